// SPDX-License-Identifier: MIT
// Table 2: every setting shown with its figures; headings sort, the choices below them filter.

function axisColumn(axis) {
  return { key: axis.key, title: axis.title, axis, isText: axis.key !== "spp",
    of: (point) => axis.values.indexOf(point[axis.key]), text: (point) => axis.text(point[axis.key]) };
}

const columns = [
  ...axes.filter((axis) => axis.varies || axis.key === "precision").map(axisColumn),
  { key: "kernel", title: "kernel, s", of: (point) => point.seconds.kernel },
  { key: "wall", title: "wall, s", of: (point) => point.seconds.wall },
  { key: "rmse", title: "RMSE", of: (point) => point.rmse, isRanged: true },
  { key: "bias", title: "bias", of: biasOf },
  { key: "relmse", title: "relMSE", of: (point) => point.relmse },
  { key: "psnr", title: "PSNR, dB", of: (point) => point.psnr ?? Infinity,
    text: (point) => (isNumber(point.psnr) ? number(point.psnr) : "equal") },
  { key: "ssim", title: "SSIM", of: (point) => point.ssim, text: (point) => number(point.ssim, 4) },
  { key: "flip", title: "FLIP", of: (point) => point.flip },
];
const order = { key: "kernel", isFalling: false };

function sorted(some) {
  const column = columns.find((candidate) => candidate.key === order.key);
  const direction = order.isFalling ? -1 : 1;
  const known = (point) => column.of(point) !== null && column.of(point) !== undefined;
  return [...some].sort((a, b) => {
    if (known(a) !== known(b)) return known(a) ? -1 : 1; // what is missing stands last in either order
    const [left, right] = [column.of(a), column.of(b)];
    return left === right ? 0 : left < right ? -direction : direction;
  });
}

function heading(column) {
  const isOrder = column.key === order.key;
  const button = element("button", { type: "button" }, column.title,
    element("span", { "aria-hidden": "true" }, isOrder ? (order.isFalling ? " ↓" : " ↑") : ""));
  button.addEventListener("click", () => {
    order.isFalling = isOrder && !order.isFalling;
    order.key = column.key;
    drawSettings();
    byId("settings").querySelector(`th[data-key="${column.key}"] button`).focus();
  });
  return element("th", { scope: "col", "data-key": column.key, class: column.isText ? "text" : "",
    "aria-sort": isOrder ? (order.isFalling ? "descending" : "ascending") : "none" }, button);
}

/// All values of an axis, or one; checkboxes above Figure 1 may have left several.
function filterOf(axis) {
  const visible = axis.values.filter((value) => !state.hidden[axis.key].has(value));
  const isAll = visible.length === axis.values.length;
  const choice = isAll ? "all" : visible.length === 1 ? axis.values.indexOf(visible[0]) : "some";
  const select = element("select", { "aria-label": `Show ${axis.title}`, "data-axis": axis.key },
    option("all", "all", isAll),
    ...(choice === "some" ? [option("some", "some", true)] : []),
    ...axis.values.map((value, i) => option(i, axis.text(value), choice === i)));
  select.addEventListener("change", () => {
    const chosen = axis.values[Number(select.value)];
    state.hidden[axis.key] = new Set(select.value === "all" ? [] : axis.values.filter((value) => value !== chosen));
    tell("view");
    byId("settings").querySelector(`select[data-axis="${axis.key}"]`).focus();
  });
  return select;
}

function pinBox(point) {
  const name = `Pin ${pointName(point)}`;
  const box = element("input", { type: "checkbox", checked: state.pins.has(point.id), "aria-label": name });
  box.addEventListener("change", () => togglePin(point.id));
  return element("td", {}, box, element("b", {}, state.pins.get(point.id) ?? ""));
}

/// Half of the 95 % interval beside the value; the interval itself is shown with the setting.
function halfWidth(point) {
  return isNumber(point.rmse_low) ? `\u00a0± ${percent((point.rmse_high - point.rmse_low) / 2 / point.rmse)}` : "";
}

function settingRow(point, front) {
  const cells = columns.map((column) => element("td", { class: column.isText ? "text" : "" },
    column.text ? column.text(point) : number(column.of(point)),
    ...(column.isRanged ? [element("small", {}, halfWidth(point))] : [])));
  const dot = front.has(point) ? [element("span", { role: "img", "aria-label": "on the front" }, "●")] : [];
  return element("tr", { "data-id": point.id }, pinBox(point), element("td", { class: "text" }, ...dot), ...cells);
}

function drawSettings() {
  const front = new Set(frontNow());
  const filters = columns.map((column) => element("td", {}, ...(column.axis?.varies ? [filterOf(column.axis)] : [])));
  const plain = ["pin", "front"].map((title) => element("th", { scope: "col" }, title));
  byId("settings").replaceChildren(
    element("thead", {},
      element("tr", {}, ...plain, ...columns.map(heading)),
      element("tr", { class: "filters" }, element("td"), element("td"), ...filters)),
    element("tbody", {}, ...sorted(shownPoints()).map((point) => settingRow(point, front))));
}

function startSettings() {
  byId("front-only").addEventListener("change", (event) => {
    state.frontOnly = event.target.checked;
    tell("view");
  });
  on(["view"], () => {
    byId("front-only").checked = state.frontOnly;
    drawSettings();
  });
  on(["pins"], () => {
    for (const row of byId("settings").tBodies[0]?.rows ?? []) {
      row.cells[0].replaceWith(pinBox(points.get(row.dataset.id)));
    }
  });
}
