// SPDX-License-Identifier: MIT
// What was measured: points, the axes along which their settings differ, and the curves of equal settings but spp.

const study = JSON.parse(byId("study").textContent);
const pictures = JSON.parse(byId("pictures").textContent);
const points = new Map(study.points.map((point) => [point.id, point]));

// Known tiers keep their place, so that colours are the same in every report.
const tiers = [...new Set(["fast", "stable", "robust", "double", ...study.points.map((point) => point.precision)])];

/// -1 is no limit; null stands where an integrator has no depth at all.
function depthName(depth) {
  if (depth === null) return "no depth";
  return depth < 0 ? "no depth limit" : `depth\u00a0${depth}`;
}

const axes = [
  { key: "precision", title: "precision", text: (value) => value, rank: (value) => tiers.indexOf(value) },
  { key: "sampler", title: "sampler", text: (value) => value, rank: null },
  { key: "max_depth", title: "depth",
    text: (value) => (value === null ? missing : value < 0 ? "no limit" : String(value)),
    rank: (value) => (value === null || value < 0 ? Infinity : value) },
  { key: "generic", title: "program", text: (value) => (value ? "generic" : "specialised"), rank: Number },
  { key: "spp", title: "spp", text: String, rank: Number },
];

for (const axis of axes) {
  axis.values = [...new Set(study.points.map((point) => point[axis.key]))];
  axis.values.sort(axis.rank ? (a, b) => (axis.rank(a) === axis.rank(b) ? 0 : axis.rank(a) - axis.rank(b)) : undefined);
  axis.varies = axis.values.length > 1;
}

const axisOf = (key) => axes.find((axis) => axis.key === key);
const curveAxes = axes.filter((axis) => axis.key !== "spp");
const curveKey = (settings) => JSON.stringify(curveAxes.map((axis) => settings[axis.key]));

function curveName(settings) {
  const words = [settings.precision, settings.sampler];
  if (axisOf("max_depth").varies) words.push(depthName(settings.max_depth));
  if (settings.generic) words.push("generic");
  return words.join(" · ");
}

function pointName(point) {
  return `${curveName(point)} · ${point.spp}\u00a0spp`;
}

function curvesOf(some) {
  const found = new Map();
  for (const point of some) {
    const key = curveKey(point);
    if (!found.has(key)) found.set(key, { key, settings: point, name: curveName(point), points: [] });
    found.get(key).points.push(point);
  }
  const ranks = (curve) => curveAxes.map((axis) => axis.values.indexOf(curve.settings[axis.key]));
  const curves = [...found.values()];
  for (const curve of curves) curve.points.sort((a, b) => a.spp - b.spp);
  return curves.sort((a, b) => {
    const [left, right] = [ranks(a), ranks(b)];
    const differing = left.findIndex((rank, i) => rank !== right[i]);
    return differing < 0 ? 0 : left[differing] - right[differing];
  });
}

const fits = new Map(study.fits.map((fit) => [curveKey(fit), fit]));
