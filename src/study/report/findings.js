// SPDX-License-Identifier: MIT
// The paragraph that says in words what this study shows; each sentence only where its figures are there.

/// Medians over all pairs of points that differ along one axis only: ratio of `of` at `value` to that at `base`.
function ratioAlong(key, value, base, of) {
  const partner = (point) => study.points.find((other) =>
    axes.every((axis) => other[axis.key] === (axis.key === key ? base : point[axis.key])));
  return median(study.points.filter((point) => point[key] === value).map((point) => {
    const other = partner(point);
    return other ? of(point) / of(other) : null;
  }));
}

function aboutFront() {
  const front = frontOf(study.points, measures.rmse, clocks.kernel);
  if (front.length < 2) return [];
  const first = front[0], last = front.at(-1);
  return [`The front has ${front.length} of the ${study.points.length} settings. It begins at ${pointName(first)} ` +
    `(${seconds(first.seconds.kernel)}, RMSE ${number(first.rmse)}) and ends at ${pointName(last)} ` +
    `(${seconds(last.seconds.kernel)}, RMSE ${number(last.rmse)}).`];
}

/// Over samples, which no clock disturbs; only where a fit is sure that the error falls.
function aboutSlopes() {
  const deepest = axisOf("max_depth").values.at(-1);
  const parts = axisOf("sampler").values.flatMap((sampler) => {
    const falling = study.fits.filter((fit) =>
      fit.sampler === sampler && fit.max_depth === deepest && fit.samples_slope < 0 && fit.samples_slope_high < 0);
    if (falling.length === 0) return [];
    const slope = median(falling.map((fit) => fit.samples_slope));
    return [`${number(slope, 2)} for ${sampler} (half of it takes ${times(halvingCost(slope))} as many)`];
  });
  if (parts.length === 0) return [];
  return [`With more samples the error falls with a slope of ${parts.join(", ")}. Samples that know nothing of each other ` +
    `must have −½, that is ${times(4)}; whatever falls more steeply places its samples better.`];
}

/// Where most of the error that is left at the most samples is bias, no more samples help.
function aboutDepth() {
  const stuck = curvesOf(study.points).map((curve) => curve.points.at(-1))
    .filter((point) => biasOf(point) ** 2 > 0.5 * point.mse && point.max_depth !== axisOf("max_depth").values.at(-1));
  return axisOf("max_depth").values.flatMap((depth) => {
    const some = stuck.filter((point) => point.max_depth === depth);
    if (some.length === 0) return [];
    const floor = median(some.map(biasOf)), share = median(some.map((point) => point.bias2 / point.mse));
    return [`With ${depthName(depth)} the error stops near ${number(floor, 2)}: at the most samples ${percent(share)} of the ` +
      "squared error is bias. That light takes more bounces than were followed, and no number of samples brings it back."];
  });
}

function aboutTiers() {
  const base = "robust";
  if (!axisOf("precision").values.includes(base)) return [];
  const parts = axisOf("precision").values.filter((tier) => tier !== base).flatMap((tier) => {
    const time = ratioAlong("precision", tier, base, clocks.kernel.of);
    const error = ratioAlong("precision", tier, base, measures.rmse.of);
    if (time === null) return [];
    const same = Math.abs(error - 1) < 0.01 ? "the same error" : `${times(error)} the error`;
    return [`${tier} takes ${times(time)} the kernel time at ${same}`];
  });
  return parts.length > 0 ? [`Beside robust, and with everything else equal, ${parts.join("; ")}.`] : [];
}

function aboutPrograms() {
  if (!axisOf("generic").varies) return [];
  const kernel = ratioAlong("generic", true, false, clocks.kernel.of);
  const building = (point) => (point.program_from_cache ? NaN : point.seconds.program);
  const program = ratioAlong("generic", true, false, building);
  if (kernel === null) return [];
  return ["The generic program, which holds every effect whether the scene calls for it or not, takes " +
    `${times(kernel)} the kernel time of the specialised one` +
    (isNumber(program) ? `, and ${times(program)} the time to get ready.` : ".")];
}

function aboutReference() {
  if (!isNumber(study.reference.rmse)) return [];
  return [`The reference is a rendering too, with an RMSE of ${number(study.reference.rmse)} of its own: differences much ` +
    "smaller than that mean nothing."];
}

function writeFindings() {
  for (const about of [aboutFront, aboutSlopes, aboutDepth, aboutTiers, aboutPrograms, aboutReference]) {
    byId("findings").append(...about().map((sentence) => element("li", {}, sentence)));
  }
}
