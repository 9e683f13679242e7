// SPDX-License-Identifier: MIT
// Pointer and keys in Figure 1: the nearest mark is looked at, a click or Enter pins it, arrows go from mark to mark.

const reach = 32; // pixels from which a mark is taken for meant

function nearestTo(event) {
  const box = byId("drawing").getBoundingClientRect();
  const scale = plot.width / box.width;
  const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
  let best = null, least = reach;
  for (const place of plot.places.values()) {
    const distance = Math.hypot(place.x - x, place.y - y);
    if (distance < least) [best, least] = [place.point.id, distance];
  }
  return best;
}

/// The setting's name beside its mark, on the side where there is room; what is behind it stays guessable.
function labelOf(point, at) {
  const curve = fits.get(curveKey(point));
  const lines = [curveName(point),
    `${point.spp} spp · ${seconds(clockNow().of(point))} · ${measureNow().title} ${number(measureNow().of(point))}`];
  if (fitsApply() && isNumber(curve?.slope)) lines.push(`slope of this curve ${number(curve.slope, 2)}`);
  const text = drawn("text", {}, ...lines.map((line, i) => drawn("tspan", { x: 0, dy: i === 0 ? 0 : "1.4em" }, line)));
  const group = drawn("g", { class: "label" }, drawn("rect", {}), text);
  byId("over").append(group);
  const box = text.getBBox();
  filledWith(group.firstChild, { x: box.x - 7, y: box.y - 5, width: box.width + 14, height: box.height + 10 }, []);
  const width = box.width + 14, height = box.height + 10;
  const left = at.x + 16 + width < plot.width ? at.x + 16 : Math.max(2, at.x - 16 - width);
  const isBeside = left > at.x || left + width < at.x;
  const above = at.y - 14 - height;
  const beside = Math.max(2, Math.min(at.y - height / 2, plot.height - height - 2));
  const top = isBeside ? beside : above > 2 ? above : at.y + 16;
  group.setAttribute("transform", `translate(${left - box.x + 7},${top - box.y + 5})`);
}

function showLook() {
  const svg = byId("drawing"), over = byId("over");
  if (!over) return;
  over.querySelectorAll(".label, .ring").forEach((node) => node.remove());
  const at = state.highlit ? plot.places.get(state.looked) : null;
  svg.classList.toggle("looking", Boolean(at));
  for (const series of svg.querySelectorAll(".series")) {
    series.classList.toggle("looked-at", Boolean(at) && series.dataset.curve === curveKey(at.point));
  }
  const stop = plot.places.get(state.looked) ?? plot.places.values().next().value;
  for (const place of plot.places.values()) place.node.setAttribute("tabindex", place === stop ? 0 : -1);
  if (!at) return;
  over.append(drawn("circle", { class: "ring", cx: at.x, cy: at.y, r: 10 }));
  labelOf(at.point, at);
}

function showPins() {
  const over = byId("over");
  over?.querySelectorAll(".pin").forEach((node) => node.remove());
  for (const place of plot.places.values()) {
    place.node.setAttribute("aria-pressed", state.pins.has(place.point.id));
    place.node.setAttribute("aria-label", pointLabel(place.point));
  }
  for (const [id, letter] of state.pins) {
    const at = plot.places.get(id);
    if (!at) continue;
    over.prepend(drawn("g", { class: "pin", transform: `translate(${at.x},${at.y})` },
      drawn("circle", { r: 9 }), drawn("text", { x: -12, y: -10, "text-anchor": "middle" }, letter)));
  }
}

/// The mark one step along its curve, or the one most like it on the next curve.
function neighbourOf(id, key) {
  const row = plot.curves.findIndex((curve) => curve.points.some((point) => point.id === id));
  const curve = plot.curves[row].points;
  const column = curve.findIndex((point) => point.id === id);
  const along = { ArrowLeft: column - 1, ArrowRight: column + 1, Home: 0, End: curve.length - 1 };
  if (key in along) return curve[along[key]]?.id;
  const next = plot.curves[row + (key === "ArrowDown" ? 1 : -1)];
  const distance = (point) => Math.abs(Math.log2(point.spp / curve[column].spp));
  return next && [...next.points].sort((a, b) => distance(a) - distance(b))[0].id;
}

function pressed(event) {
  const id = event.target.closest?.("[data-id]")?.dataset.id;
  if (!id || event.altKey || event.ctrlKey || event.metaKey) return;
  if (event.key === "Enter" || event.key === " ") {
    togglePin(id);
  } else if (["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"].includes(event.key)) {
    const next = neighbourOf(id, event.key);
    if (next) plot.places.get(next).node.focus();
  } else {
    return;
  }
  event.preventDefault();
}

/// Where the pointer is at nothing, the mark that the keys have reached is looked at.
function lookBack(id) {
  look(id ?? byId("drawing").querySelector("[data-id]:focus-visible")?.dataset.id ?? null);
}

function startPointing() {
  const svg = byId("drawing");
  svg.addEventListener("pointermove", (event) => lookBack(nearestTo(event)));
  svg.addEventListener("pointerleave", () => lookBack(null));
  svg.addEventListener("click", (event) => {
    const id = nearestTo(event);
    if (!id) return;
    look(id);
    togglePin(id);
  });
  svg.addEventListener("focusin", (event) => look(event.target.dataset.id ?? null));
  svg.addEventListener("focusout", () => look(null));
  svg.addEventListener("keydown", pressed);
  on(["look"], showLook);
  on(["pins"], showPins);
}
