// SPDX-License-Identifier: MIT
// What the reader has chosen, and who is told when that changes: "view" (what is shown, by which axes), "look" (the
// setting under the pointer or the focus), "pins".

const state = {
  measure: "rmse",
  clock: "kernel",
  hidden: Object.fromEntries(axes.map((axis) => [axis.key, new Set()])),
  frontOnly: false,
  looked: null, // an id; what is shown large stays when the pointer leaves
  highlit: false,
  pins: new Map(), // id -> letter
};

const listeners = { view: [], look: [], pins: [] };

function on(topics, listener) {
  for (const topic of topics) listeners[topic].push(listener);
}

function tell(topic) {
  for (const listener of listeners[topic]) listener();
}

const measureNow = () => measures[state.measure];
const clockNow = () => clocks[state.clock];

function filteredPoints() {
  return study.points.filter((point) => axes.every((axis) => !state.hidden[axis.key].has(point[axis.key])));
}

function frontNow() {
  return frontOf(filteredPoints(), measureNow(), clockNow());
}

function shownPoints() {
  return state.frontOnly ? frontNow() : filteredPoints();
}

function look(id) {
  const highlit = id !== null;
  if (highlit === state.highlit && (id === null || id === state.looked)) return;
  state.highlit = highlit;
  state.looked = id ?? state.looked;
  tell("look");
}

function freeLetter() {
  const taken = new Set(state.pins.values());
  for (let i = 0; ; ++i) {
    const letter = String.fromCharCode(65 + (i % 26)) + (i >= 26 ? Math.floor(i / 26) : "");
    if (!taken.has(letter)) return letter;
  }
}

function togglePin(id) {
  if (!state.pins.delete(id)) state.pins.set(id, freeLetter());
  tell("pins");
}
