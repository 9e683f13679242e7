// SPDX-License-Identifier: MIT
// The frame of Figure 1: both axes with their lines and labels, and what independent samples would do.

function drawAxes(svg, x, y, width, titles) {
  const lines = drawn("g", { class: "grid" }), labels = drawn("g", { class: "axis", "aria-hidden": "true" });
  for (const tick of ticksOf(x, width < 520 ? 54 : 58)) {
    const at = x.at(tick.value).toFixed(1);
    if (tick.isPower) lines.append(drawn("path", { d: `M${at},${y.start}V${y.end}` }));
    labels.append(drawn("path", { class: "tick", d: `M${at},${y.start}v${tick.isPower ? 7 : 4}` }));
    if (tick.isLabelled) {
      const label = seconds(tick.value, shortNumber);
      labels.append(drawn("text", { x: at, y: y.start + 22, "text-anchor": "middle" }, label));
    }
  }
  for (const tick of ticksOf(y, 24)) {
    const at = y.at(tick.value).toFixed(1);
    if (tick.isPower) lines.append(drawn("path", { d: `M${x.start},${at}H${x.end}` }));
    labels.append(drawn("path", { class: "tick", d: `M${x.start},${at}h${tick.isPower ? -7 : -4}` }));
    if (tick.isLabelled) {
      const label = shortNumber(tick.value);
      labels.append(drawn("text", { x: x.start - 11, y: at, dy: "0.35em", "text-anchor": "end" }, label));
    }
  }
  labels.append(
    drawn("path", { class: "tick", d: `M${x.start},${y.end}V${y.start}H${x.end}` }),
    drawn("text", { class: "title", x: x.end, y: y.start + 44, "text-anchor": "end" }, `${titles.x} →`),
    drawn("text", { class: "title", x: 2, y: y.end - 12 }, `↑ ${titles.y}`));
  svg.append(lines, labels);
}

/// A triangle in the corner that no setting reaches: four times as many samples, half the error.
function drawGuide(svg, x, y, isAboveReference) {
  const floor = isAboveReference ? y.at(study.reference.rmse_high || study.reference.rmse) : y.start;
  const left = x.start + 16, bottom = Math.min(floor, y.start) - (isAboveReference ? 42 : 26);
  const right = left + x.at(4) - x.at(1), top = bottom + y.at(2) - y.at(1);
  svg.append(drawn("g", { class: "guide", "aria-hidden": "true" },
    drawn("path", { d: `M${left},${top}L${right},${bottom}H${left}Z` }),
    drawn("text", { x: left, y: bottom + 16 }, "4 × the time: half the error"),
    drawn("text", { x: (left + right) / 2 + 6, y: (top + bottom) / 2 - 4 }, "slope −½")));
}

/// Where the reference itself is uncertain, no distance from it says much.
function drawReference(svg, x, y) {
  const { rmse, rmse_low: low, rmse_high: high } = study.reference;
  const band = drawn("g", { class: "reference", "aria-hidden": "true" });
  if (low > 0 && high > 0) {
    const top = Math.max(y.at(high), y.end), bottom = Math.min(y.at(low), y.start);
    band.append(drawn("rect", { x: x.start, y: top, width: x.end - x.start, height: Math.max(1, bottom - top) }));
  }
  band.append(drawn("path", { d: `M${x.start},${y.at(rmse)}H${x.end}` }),
    drawn("text", { x: x.end - 4, y: y.at(high ?? rmse) - 6, "text-anchor": "end" }, "the reference’s own error"));
  svg.append(band);
}
