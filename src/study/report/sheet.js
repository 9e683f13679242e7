// SPDX-License-Identifier: MIT
// Figure 3: every picture, curves as rows, samples per pixel as columns.

let sheetShows = "picture";

function thumbnailOf(point) {
  const name = pointName(point);
  const picture = pictureOf(point[sheetShows], "");
  picture.loading = "lazy";
  const button = element("button", { type: "button", "aria-pressed": state.pins.has(point.id), "data-id": point.id,
    "aria-label": `Pin ${name}: RMSE ${number(point.rmse)}, kernel time ${seconds(point.seconds.kernel)}` }, picture);
  button.addEventListener("click", () => togglePin(point.id));
  return element("td", {}, button, element("span", {}, `${number(point.rmse)} · ${seconds(point.seconds.kernel)}`));
}

function drawSheet() {
  const shown = shownPoints();
  const counts = axisOf("spp").values.filter((spp) => shown.some((point) => point.spp === spp));
  const rows = curvesOf(shown).map((curve) => element("tr", {},
    element("th", { scope: "row" }, sampleOf(curve.settings), element("span", {}, curve.name)),
    ...counts.map((spp) => {
      const point = curve.points.find((candidate) => candidate.spp === spp);
      return point ? thumbnailOf(point) : element("td");
    })));
  const headings = counts.map((spp) => element("th", { scope: "col" }, `${spp} spp`));
  byId("sheet").replaceChildren(
    element("thead", {}, element("tr", {}, element("td"), ...headings)),
    element("tbody", {}, ...rows));
}

function startSheet() {
  for (const radio of document.querySelectorAll("input[name=sheet]")) {
    radio.addEventListener("change", () => {
      sheetShows = radio.value;
      drawSheet();
    });
  }
  on(["view"], drawSheet);
  on(["pins"], () => {
    for (const button of byId("sheet").querySelectorAll("button")) {
      button.setAttribute("aria-pressed", state.pins.has(button.dataset.id));
    }
  });
}
