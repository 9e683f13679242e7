// SPDX-License-Identifier: MIT
// How a setting looks in Figure 1, with and without colour: the tier by colour and shape, the sampler by hollow, solid or
// hollow with a dot, the depth by the dashes of its curve, the generic program by a stroke through the mark.

const shapes = ["M0,-5.6L5.4,4.2H-5.4Z", "M-4.4,-4.4H4.4V4.4H-4.4Z", "M5,0A5,5 0 1 1 -5,0A5,5 0 1 1 5,0Z",
  "M0,-6.2L6.2,0L0,6.2L-6.2,0Z", "M-1.8,-5.4H1.8V-1.8H5.4V1.8H1.8V5.4H-1.8V1.8H-5.4V-1.8H-1.8Z"];
const fills = ["hollow", "solid", "dotted"];
const dashes = ["", "7 3.5", "2 3", "9 3 2 3", "14 4"];

function tierClass(settings) {
  return `tier-${tiers.indexOf(settings.precision) % shapes.length}`;
}

/// The deepest is solid: it is the one without bias.
function dashOf(settings) {
  const depths = axisOf("max_depth").values;
  return dashes[(depths.length - 1 - depths.indexOf(settings.max_depth)) % dashes.length];
}

function fillOf(settings) {
  const samplers = axisOf("sampler");
  return samplers.varies ? fills[samplers.values.indexOf(settings.sampler) % fills.length] : "solid";
}

function markOf(settings) {
  const fill = fillOf(settings);
  const mark = drawn("g", { class: `mark ${tierClass(settings)} ${fill}` },
    drawn("path", { d: shapes[tiers.indexOf(settings.precision) % shapes.length] }));
  if (fill === "dotted") mark.append(drawn("circle", { r: 1.7 }));
  if (settings.generic) mark.append(drawn("path", { class: "stroke", d: "M-7.5,7.5L7.5,-7.5" }));
  return mark;
}

/// A piece of curve with a mark, as legends show it.
function sampleOf(settings) {
  const mark = markOf(settings);
  mark.setAttribute("transform", "translate(19,9)");
  return drawn("svg", { class: "sample", viewBox: "0 0 38 18", width: 38, height: 18, "aria-hidden": "true" },
    drawn("path", { class: `curve ${tierClass(settings)}`, d: "M1,9H37", "stroke-dasharray": dashOf(settings) }), mark);
}

/// What of a mark or a curve one value of one axis decides.
function axisSample(key, value) {
  const plain = { precision: null, sampler: null, max_depth: axisOf("max_depth").values.at(-1), generic: false };
  const frame = { class: "sample", height: 18, "aria-hidden": "true" };
  if (key === "max_depth") {
    return drawn("svg", { ...frame, viewBox: "0 0 38 18", width: 38 },
      drawn("path", { class: "curve", d: "M1,9H37", "stroke-dasharray": dashOf({ ...plain, max_depth: value }) }));
  }
  const settings = { ...plain, precision: "robust", sampler: axisOf("sampler").values.at(-1), [key]: value };
  const mark = markOf(settings);
  if (key !== "precision") mark.classList.remove(tierClass(settings));
  mark.setAttribute("transform", "translate(9,9)");
  return drawn("svg", { ...frame, viewBox: "0 0 18 18", width: 18 }, mark);
}
