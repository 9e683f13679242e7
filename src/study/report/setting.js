// SPDX-License-Identifier: MIT
// The setting looked at, beside Figure 1: its pictures and figures; and the row of pinned settings.

function pictureOf(name, text) {
  const { width, height } = study;
  return element("img", { src: pictures[name] ?? null, alt: text, width, height, decoding: "async" });
}

function factsOf(point) {
  const { program, bvh, upload, kernel, wall } = point.seconds;
  const rows = [
    ["RMSE", number(point.rmse)],
    ["95 %", range(point.rmse_low, point.rmse_high)],
    ["of it bias", number(biasOf(point))],
    ["relMSE", number(point.relmse)],
    ["PSNR", isNumber(point.psnr) ? `${number(point.psnr)} dB` : "equal"],
    ["SSIM", number(point.ssim, 4)],
    ["FLIP", number(point.flip)],
    ["kernel", seconds(kernel)],
    ["wall", seconds(wall)],
    ["program, tree, upload", `${seconds(program)}, ${seconds(bvh)}, ${seconds(upload)}`],
    ["seeds", String(point.seeds)],
  ];
  return element("dl", {}, ...rows.flatMap(([term, fact]) => [element("dt", {}, term), element("dd", {}, fact)]));
}

function showSetting() {
  const point = points.get(state.looked);
  const pinned = state.pins.has(point.id);
  const button = element("button", { type: "button", "aria-pressed": pinned }, pinned ? "Unpin" : "Pin");
  button.addEventListener("click", () => {
    togglePin(point.id);
    byId("setting").querySelector("button").focus();
  });
  byId("setting").replaceChildren(
    element("h3", {}, pointName(point)),
    pictureOf(point.picture, `Picture of ${pointName(point)}`), factsOf(point), element("p", {}, button));
}

function showPinned() {
  const chips = [...state.pins].map(([id, letter]) => {
    const name = pointName(points.get(id));
    const button = element("button", { type: "button", "aria-label": `Unpin ${name}` },
      element("b", {}, letter), ` ${name} `, element("span", { "aria-hidden": "true" }, "×"));
    button.addEventListener("click", () => togglePin(id));
    button.addEventListener("pointerenter", () => look(id));
    button.addEventListener("pointerleave", () => look(null));
    return button;
  });
  byId("pins").replaceChildren(...(chips.length > 0 ? ["Pinned: ", ...chips] : ["Nothing is pinned yet."]));
}

function startSetting() {
  on(["look", "pins"], showSetting);
  on(["pins"], showPinned);
}
