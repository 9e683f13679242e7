// SPDX-License-Identifier: MIT
// Table 1, the legend of curves: how fast the error falls along each of them, and what half of it costs.

/// error ∝ time^slope, so half the error takes 2^(−1/slope) times the time; what does not fall never gets there.
function halvingCost(slope) {
  return slope < 0 ? 2 ** (-1 / slope) : null;
}

function slopeRow(curve) {
  const fit = fits.get(curve.key);
  const cost = fit ? halvingCost(fit.slope) : null;
  const half = cost === null ? "never" : cost < 100 ? `${times(cost)} the time` : "more than 100 × the time";
  return element("tr", { "data-curve": curve.key },
    element("th", { scope: "row" }, sampleOf(curve.settings), ` ${curve.name}`),
    element("td", {}, fit ? number(fit.slope, 2) : missing),
    element("td", {}, range(fit?.slope_low, fit?.slope_high, 2)),
    element("td", {}, fit ? half : missing),
    element("td", {}, number(fit?.samples_slope, 2)),
    element("td", {}, String(fit?.points ?? missing)));
}

function drawSlopes() {
  const titles = ["curve", "slope", "95 %", "half the error takes", "slope over samples", "points"];
  byId("slopes").replaceChildren(
    element("thead", {}, element("tr", {}, ...titles.map((title) => element("th", { scope: "col" }, title)))),
    element("tbody", {}, ...curvesOf(shownPoints()).map(slopeRow)));
}

function startSlopes() {
  byId("slopes-note").textContent = "Slopes of RMSE against kernel time, fitted on logarithmic axes. Independent samples " +
    "without bias have −½: half the error takes four times the time; over samples it is free of what a launch costs " +
    "before its first sample. Where a curve bends towards its bias no one slope describes it.";
  on(["view"], drawSlopes);
  byId("slopes").addEventListener("pointerover", (event) => {
    const key = event.target.closest("tr")?.dataset.curve;
    const curve = plot.curves.find((candidate) => candidate.key === key);
    look(curve ? curve.points.at(-1).id : null);
  });
  byId("slopes").addEventListener("pointerleave", () => look(null));
}
