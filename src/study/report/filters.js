// SPDX-License-Identifier: MIT
// The choices above Figure 1: which error, which time, what to draw; the values of axes, which are its legend too.

function checkboxOf(axis, value) {
  const box = element("input", { type: "checkbox", checked: true });
  box.addEventListener("change", () => {
    if (box.checked) state.hidden[axis.key].delete(value);
    else state.hidden[axis.key].add(value);
    tell("view");
  });
  on(["view"], () => { box.checked = !state.hidden[axis.key].has(value); });
  return element("label", {}, box, axisSample(axis.key, value), ` ${axis.text(value)}`);
}

function showCount() {
  const shown = shownPoints().length, all = study.points.length;
  byId("shown").textContent = `${shown === all ? "All" : `${shown} of`} ${all} settings are shown.`;
  byId("show-all").hidden = shown === all;
}

function showEverything() {
  state.frontOnly = false;
  for (const axis of axes) state.hidden[axis.key].clear();
  tell("view");
  byId("plot-title").scrollIntoView({ block: "nearest" });
}

function startFilters() {
  for (const [select, choices, key] of [["measure", measures, "measure"], ["time", clocks, "clock"]]) {
    const offered = Object.entries(choices).filter(([, choice]) => study.points.some((point) => choice.of(point) > 0));
    for (const [name, choice] of offered) byId(select).append(option(name, choice.title, name === state[key]));
    byId(select).addEventListener("change", (event) => {
      state[key] = event.target.value;
      tell("view");
    });
  }
  for (const axis of curveAxes.filter((candidate) => candidate.varies)) {
    byId("filters").append(element("fieldset", {}, element("legend", {}, axis.title),
      ...axis.values.map((value) => checkboxOf(axis, value))));
  }
  for (const id of ["draw-front", "draw-curves", "draw-fits"]) byId(id).addEventListener("change", () => tell("view"));
  byId("choices").addEventListener("submit", (event) => event.preventDefault());
  byId("show-all").addEventListener("click", showEverything);
  on(["view"], showCount);
}
