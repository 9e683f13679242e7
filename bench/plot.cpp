// SPDX-License-Identifier: MIT
// Colours: M. Okabe and K. Ito, "Color Universal Design", 2008.
#include "bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace strahl::bench {
namespace {

constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#777777", "#000000"};
constexpr double left = 60, top = 40, width = 560, height = 260;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else
      out += c;
  }
  return out;
}

/// 1, 2 or 5 times a power of ten: about five steps up to `most`.
double tick_step(double most) {
  const double raw = most / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10 * power;
}

class Drawing {
 public:
  Drawing(const std::string& title, const std::string& y_label, const std::vector<Series>& series, double below,
          double reference = 0) {
    double most = reference;
    for (const Series& one : series)
      for (const double y : one.y)
        if (y > most) most = y;
    const double step = tick_step(most > 0 ? most : 1);
    most_ = step * std::ceil(most / step + 0.01);
    const double names = 18 * static_cast<double>(series.size());
    body_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
        "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        left + width + 20, top + height + below + names + 10);
    text(left, 22, "start", title, " font-weight=\"bold\" font-size=\"14\"");
    text(left - 50, top - 6, "start", y_label);
    for (double y = 0; y <= most_ * 1.001; y += step) {
      line(left, at(y), left + width, at(y), "#dddddd", 1);
      text(left - 6, at(y) + 4, "end", fmt::format("{:g}", y));
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
      const double y = top + height + below + 18 * static_cast<double>(i);
      rect(left, y, 12, 12, i);
      text(left + 18, y + 10, "start", series[i].name);
    }
  }

  [[nodiscard]] double at(double y) const { return top + height - height * y / most_; }
  static const char* colour(std::size_t i) { return colours[i % colours.size()]; }

  void text(double x, double y, const char* anchor, const std::string& what, const std::string& more = {}) {
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                         escaped(what));
  }
  void line(double x0, double y0, double x1, double y1, const char* stroke, double thick) {
    body_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", x0, y0,
        x1, y1, stroke, thick);
  }
  void rect(double x, double y, double w, double h, std::size_t series) {
    body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x, y, w,
                         h, colour(series));
  }
  void circle(double x, double y, std::size_t series) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x, y, colour(series));
  }
  [[nodiscard]] std::string finish() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
  double most_ = 1;
};

}  // namespace

std::string line_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                      const std::vector<Series>& series) {
  Drawing drawing(title, y_label, series, 50);
  double least = HUGE_VAL, most = 0;
  for (const Series& one : series)
    for (const double x : one.x) {
      least = std::min(least, x);
      most = std::max(most, x);
    }
  const double low = std::floor(std::log10(least)), high = std::max(low + 1, std::ceil(std::log10(most)));
  const auto at = [low, high](double x) { return left + width * (std::log10(x) - low) / (high - low); };
  for (double power = low; power <= high; ++power) {
    const double x = at(std::pow(10, power));
    drawing.line(x, top, x, top + height, "#dddddd", 1);
    drawing.text(x, top + height + 16, "middle", fmt::format("{:g}", std::pow(10, power)));
  }
  drawing.text(left + width, top + height + 34, "end", x_label);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (std::size_t k = 0; k < one.x.size(); ++k) {
      if (std::isnan(one.y[k])) continue;
      drawing.circle(at(one.x[k]), drawing.at(one.y[k]), i);
      if (k > 0 && !std::isnan(one.y[k - 1]))
        drawing.line(at(one.x[k - 1]), drawing.at(one.y[k - 1]), at(one.x[k]), drawing.at(one.y[k]), Drawing::colour(i),
                     2);
    }
  }
  return drawing.finish();
}

std::string bar_plot(const std::string& title, const std::string& y_label, const std::vector<std::string>& groups,
                     const std::vector<Series>& series, double reference) {
  Drawing drawing(title, y_label, series, 110, reference);
  const double group = width / static_cast<double>(groups.size()),
               bar = 0.8 * group / static_cast<double>(series.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double start = left + group * (static_cast<double>(g) + 0.1);
    for (std::size_t i = 0; i < series.size(); ++i) {
      const double y = series[i].y[g];
      if (!std::isnan(y))
        drawing.rect(start + bar * static_cast<double>(i), drawing.at(y), bar, top + height - drawing.at(y), i);
    }
    const double x = start + 0.4 * group, y = top + height + 14;
    drawing.text(x, y, "end", groups[g], fmt::format(" transform=\"rotate(-35 {:.1f} {:.1f})\"", x, y));
  }
  drawing.line(left, drawing.at(reference), left + width, drawing.at(reference), "#000000", 1);
  return drawing.finish();
}

}  // namespace strahl::bench
