// SPDX-License-Identifier: MIT
// Figure 2: two pictures one over the other, the left one cut off where the slider stands.

const reference = { id: "", picture: study.reference.picture };
const pair = { left: null, right: "" };

const sideOf = (id) => (id === "" ? reference : points.get(id));
const sideName = (id) => (id === "" ? "the reference" : pointName(points.get(id)));

function optionsFor(id) {
  const named = (point) => option(point.id, pointName(point), point.id === id);
  const pinned = [...state.pins].map(([pin, letter]) => option(pin, `${letter}  ${sideName(pin)}`, pin === id));
  const rest = study.points.filter((point) => !state.pins.has(point.id));
  return [option("", "the reference", id === ""),
    ...(pinned.length > 0 ? [element("optgroup", { label: "pinned" }, ...pinned)] : []),
    ...curvesOf(rest).map((curve) => element("optgroup", { label: curve.name }, ...curve.points.map(named)))];
}

/// What going from one setting to the other does to error and time.
function comparison() {
  const [left, right] = [sideOf(pair.left), sideOf(pair.right)];
  if (left === right) return "Both sides are the same.";
  const one = [left, right].find((side) => side === reference);
  if (one) {
    const other = one === left ? right : left;
    return `${pointName(other)}: RMSE ${number(other.rmse)} (95 %: ${range(other.rmse_low, other.rmse_high)}) ` +
      `against the reference, after ${seconds(other.seconds.kernel)} of kernel time.`;
  }
  return `From left to right: RMSE ${number(left.rmse)} → ${number(right.rmse)} (${times(right.rmse / left.rmse)}), ` +
    `kernel time ${seconds(left.seconds.kernel)} → ${seconds(right.seconds.kernel)} ` +
    `(${times(right.seconds.kernel / left.seconds.kernel)}).`;
}

function moveDivider() {
  const share = Number(byId("slider").value);
  byId("pair").style.setProperty("--share", `${share}%`);
  byId("slider").setAttribute("aria-valuetext",
    `${Math.round(share)} %: to the left ${sideName(pair.left)}, to the right ${sideName(pair.right)}`);
}

function showDifferences() {
  const sides = [["Left", pair.left], ["Right", pair.right]].filter(([, id]) => sideOf(id).difference);
  const figures = sides.map(([side, id]) =>
    element("figure", {}, pictureOf(sideOf(id).difference, `Difference of ${sideName(id)} from the reference`),
      element("figcaption", {}, `${side}: difference from the reference`)));
  const note = element("p", { class: "note" }, "Relative to the reference, in false colours on a logarithmic scale: black up to 0.1 %, white from 100 %.");
  byId("differences").replaceChildren(...figures, ...(figures.length > 0 ? [note] : []));
}

function showPair() {
  for (const side of ["left", "right"]) byId(side).replaceChildren(...optionsFor(pair[side]));
  const image = (side) => {
    const picture = pictureOf(sideOf(pair[side]).picture, `Picture of ${sideName(pair[side])}`);
    picture.className = side;
    picture.draggable = false;
    return picture;
  };
  byId("pair").replaceChildren(image("right"), image("left"), element("div", { class: "divider" }),
    element("span", { class: "tag left", "aria-hidden": "true" }, sideName(pair.left)),
    element("span", { class: "tag right", "aria-hidden": "true" }, sideName(pair.right)));
  byId("pair-note").textContent = comparison();
  showDifferences();
  moveDivider();
}

function dragDivider(event) {
  if (event.type === "pointermove" && event.buttons === 0) return;
  const box = byId("pair").getBoundingClientRect();
  byId("slider").value = (100 * (event.clientX - box.left)) / box.width;
  moveDivider();
}

function startPair() {
  for (const side of ["left", "right"]) {
    byId(side).addEventListener("change", (event) => {
      pair[side] = event.target.value;
      showPair();
      byId(side).focus();
    });
  }
  byId("slider").addEventListener("input", moveDivider);
  byId("pair").addEventListener("pointerdown", dragDivider);
  byId("pair").addEventListener("pointermove", dragDivider);
  for (const id of ["pair", "slider"]) byId(id).style.setProperty("--ratio", study.width / study.height);
  let known = new Set();
  on(["pins"], () => {
    const fresh = [...state.pins.keys()].find((id) => !known.has(id));
    known = new Set(state.pins.keys());
    pair.left = fresh ?? pair.left ?? state.looked;
    showPair();
  });
}
