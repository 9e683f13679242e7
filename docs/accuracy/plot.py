# SPDX-License-Identifier: MIT
"""One plot as SVG: lines and points over two axes, linear or logarithmic. Colours: Okabe and Ito, "Color Universal
Design" (2008), which the colour-blind can tell apart; every series has a mark of its own as well."""
import html
import math

COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#999999"]
WIDTH, HEIGHT = 640, 400
LEFT, TOP, BOTTOM = 70, 50, 346


def mark(shape, x, y, colour, title):
    size = 4
    shapes = [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size}"',
              f'<rect x="{x - size:.1f}" y="{y - size:.1f}" width="{2 * size}" height="{2 * size}"',
              f'<path d="M{x:.1f} {y - 5:.1f}l5 9h-10z"',
              f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z"']
    return f'{shapes[shape % 4]} fill="{colour}"><title>{html.escape(title)}</title></' + \
        ("circle>" if shape % 4 == 0 else "rect>" if shape % 4 == 1 else "path>")


def superscript(power):
    return f"10{str(power).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


class Axis:
    """Values to pixels, and where the ticks are."""

    def __init__(self, values, log, start, end):
        self.log, self.start, self.end = log, start, end
        if log:
            low, high = (math.log10(f(v for v in values if v > 0)) for f in (min, max))
            self.low, self.high = math.floor(low), math.ceil(high)
            self.high += self.high == self.low
            step = 1 + (self.high - self.low) // 8
            self.ticks = [(power, superscript(power)) for power in range(self.low, self.high + 1, step)]
        else:
            high = max(values)
            step = 10 ** math.floor(math.log10(high))
            step = next(s for s in (step / 5, step / 2, step, 2 * step) if high / s <= 8)
            self.low, self.high = 0, step * math.ceil(high / step)
            self.ticks = [(i * step, f"{i * step:g}") for i in range(round(self.high / step) + 1)]

    def at(self, value):
        if self.log:
            value = math.log10(value) if value > 0 else self.low
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def tick_at(self, tick):
        return self.start + (tick - self.low) / (self.high - self.low) * (self.end - self.start)


def text(x, y, words, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{html.escape(words)}</text>'


def plot(title, x_label, y_label, series, log_x=True, log_y=True, lines=True, styles=None):
    """series: {name: [(x, y) or (x, y, words for who points at it)]}; zeros lie at the bottom of a logarithmic axis.
    styles: {name: (number of a colour, number of a mark)}, in place of one each."""
    right = 460
    points = [point for values in series.values() for point in values]
    x_axis = Axis([p[0] for p in points], log_x, LEFT, right)
    y_axis = Axis([p[1] for p in points], log_y, BOTTOM, TOP)
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
           'font-size="12">', f"<title>{html.escape(title)}</title>", '<rect width="100%" height="100%" fill="white"/>',
           text(10, 20, title, more=' font-weight="bold" font-size="14"'), text(10, 38, y_label),
           text((LEFT + right) / 2, 386, x_label, "middle")]
    for tick, label in x_axis.ticks:
        x = x_axis.tick_at(tick)
        svg += [f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{BOTTOM}" stroke="#dddddd"/>',
                text(x, BOTTOM + 18, label, "middle")]
    for tick, label in y_axis.ticks:
        y = y_axis.tick_at(tick)
        svg += [f'<line x1="{LEFT}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" stroke="#dddddd"/>',
                text(LEFT - 6, y + 4, label, "end")]
    for number, (name, values) in enumerate(series.items()):
        colour, shape = (styles or {}).get(name, (number, number))
        colour = COLOURS[colour % len(COLOURS)]
        places = [(x_axis.at(p[0]), y_axis.at(p[1])) for p in values]
        if lines:
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            svg.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        for point, (x, y) in zip(values, places):
            words = point[2] if len(point) > 2 else f"{name}: {point[0]:.4g}, {point[1]:.4g}"
            svg.append(mark(shape, x, y, colour, words))
        svg += [mark(shape, right + 22, TOP + 10 + 20 * number, colour, name),
                text(right + 34, TOP + 14 + 20 * number, name)]
    return "\n".join(svg + ["</svg>"]) + "\n"
