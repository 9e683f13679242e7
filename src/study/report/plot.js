// SPDX-License-Identifier: MIT
// Figure 1: error against time, both logarithmic, drawn anew whenever the choices or the width change.

const plot = { x: null, y: null, width: 0, height: 0, places: new Map() }; // id -> {point, x, y, node}

/// The reference's own error belongs into the picture where it is not far below everything else.
function referenceIsNear(errors) {
  return state.measure === "rmse" && study.reference.rmse > 0 && study.reference.rmse * 5 > Math.min(...errors);
}

function curveLine(curve) {
  const corners = curve.points.map((point) => plot.places.get(point.id)).map((at) => `${at.x},${at.y}`);
  return drawn("path", { class: `curve ${tierClass(curve.settings)}`, d: `M${corners.join("L")}`,
    "stroke-dasharray": dashOf(curve.settings) });
}

/// Drawn over the times that were measured; it was fitted to RMSE against kernel time only.
function fitLine(curve) {
  const fit = fits.get(curve.key);
  if (!fit || !isNumber(fit.slope) || curve.points.length < 2) return [];
  const ends = curve.points.map(clocks.kernel.of).sort((a, b) => a - b);
  const corner = (time) => `${plot.x.at(time)},${plot.y.at(fit.factor * time ** fit.slope)}`;
  const line = `M${corner(ends[0])}L${corner(ends.at(-1))}`;
  return [drawn("path", { class: `fit ${tierClass(curve.settings)}`, d: line })];
}

function errorBar(point, at) {
  const [low, high] = measureNow().bar ? measureNow().bar(point) : [];
  if (!(low > 0 && high > 0)) return [];
  return [drawn("path", { class: `bar ${tierClass(point)}`, d: `M${at.x},${plot.y.at(low)}V${plot.y.at(high)}` })];
}

function pointLabel(point) {
  const pinned = state.pins.has(point.id) ? `, pinned as ${state.pins.get(point.id)}` : "";
  return `${pointName(point)}: ${measureNow().title} ${number(measureNow().of(point))}, ` +
    `${clockNow().title} ${seconds(clockNow().of(point))}${pinned}`;
}

function drawCurve(curve) {
  const group = drawn("g", { class: "series", "data-curve": curve.key });
  if (byId("draw-curves").checked) group.append(curveLine(curve));
  if (fitsApply()) group.append(...fitLine(curve));
  for (const point of curve.points) {
    const at = plot.places.get(point.id);
    at.node = markOf(point);
    at.node.setAttribute("transform", `translate(${at.x},${at.y})`);
    filledWith(at.node, { role: "button", tabindex: -1, "data-id": point.id }, []);
    group.append(...errorBar(point, at), at.node);
  }
  return group;
}

function fitsApply() {
  return state.measure === "rmse" && state.clock === "kernel";
}

/// Its line, and the area beyond it that no setting reaches.
function drawFront(front) {
  const places = front.map((point) => plot.places.get(point.id));
  const steps = places.map((at, i) => (i === 0 ? `M${at.x},${plot.y.end}V${at.y}` : `H${at.x}V${at.y}`));
  const line = `${steps.join("")}H${plot.x.end}`;
  const nameAt = { x: plot.x.end - 4, y: places.at(-1).y + 19, "text-anchor": "end" };
  return drawn("g", { "aria-hidden": "true" },
    drawn("path", { class: "beyond", d: `${line}V${plot.y.start}H${plot.x.start}V${plot.y.end}Z` }),
    drawn("path", { class: "front", d: line }),
    drawn("text", { class: "front-name", ...nameAt }, "Pareto front"));
}

function layOut(drawable) {
  const box = byId("plot");
  plot.width = Math.max(280, Math.floor(box.clientWidth));
  plot.height = Math.round(Math.min(640, Math.max(360, plot.width * 0.68)));
  const errors = drawable.flatMap((point) => [measureNow().of(point), ...(measureNow().bar?.(point) ?? [])])
    .filter((value) => value > 0);
  if (referenceIsNear(errors)) errors.push(study.reference.rmse_low || study.reference.rmse);
  plot.x = logScale(drawable.map(clockNow().of), 64, plot.width - 10);
  plot.y = logScale(errors, plot.height - 52, 30);
  plot.places = new Map(drawable.map((point) => [point.id, { point,
    x: Number(plot.x.at(clockNow().of(point)).toFixed(1)), y: Number(plot.y.at(measureNow().of(point)).toFixed(1)) }]));
  return errors;
}

function drawPlot() {
  const svg = byId("drawing");
  const focusedId = svg.contains(document.activeElement) ? document.activeElement.dataset.id : null;
  const shown = shownPoints();
  const drawable = shown.filter((point) => isDrawable(point, measureNow(), clockNow()));
  svg.replaceChildren();
  plot.places = new Map();
  plot.curves = curvesOf(drawable);
  writeNote(shown.length - drawable.length, drawable.length);
  if (drawable.length > 0) {
    const errors = layOut(drawable);
    for (const [name, value] of [["viewBox", `0 0 ${plot.width} ${plot.height}`], ["height", plot.height]]) {
      svg.setAttribute(name, value);
    }
    if (byId("draw-front").checked) svg.append(drawFront(frontOf(drawable, measureNow(), clockNow())));
    svg.classList.toggle("fits", byId("draw-fits").checked);
    drawAxes(svg, plot.x, plot.y, plot.width,
      { x: `${clockNow().title} of one seed`, y: `${measureNow().title} against the reference` });
    if (referenceIsNear(errors)) drawReference(svg, plot.x, plot.y);
    if (state.measure === "rmse") drawGuide(svg, plot.x, plot.y, referenceIsNear(errors));
    for (const curve of plot.curves) svg.append(drawCurve(curve));
    svg.append(drawn("g", { id: "over", "aria-hidden": "true" }));
  }
  showPins();
  showLook();
  if (focusedId) (plot.places.get(focusedId)?.node ?? svg).focus();
}

function writeNote(left, drawnCount) {
  const bars = measureNow().bar ? "upright lines are 95 % intervals; " : "";
  const sentences = drawnCount === 0 ? ["No setting is left to draw."]
    : [`Each mark is the median time of one seed; ${bars}both axes are logarithmic.`];
  if (left > 0) {
    sentences.push(`${left} of the settings shown cannot stand on a logarithmic axis: their ${measureNow().title} ` +
      "is zero, or lost in noise.");
  }
  if (byId("draw-fits").checked && !fitsApply()) sentences.push("Slopes are fitted to RMSE against kernel time only.");
  byId("plot-note").textContent = sentences.join(" ");
}

function startPlot() {
  on(["view"], drawPlot);
  new ResizeObserver(() => {
    if (plot.places.size > 0 && Math.max(280, Math.floor(byId("plot").clientWidth)) !== plot.width) drawPlot();
  }).observe(byId("plot"));
}
