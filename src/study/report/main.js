// SPDX-License-Identifier: MIT
// Everything put in its place once; from then on the state tells what to draw again.

function describe() {
  const subject = study.name || study.scene;
  document.title = `${subject}: error against time`;
  byId("subject").textContent =
    `${subject}, ${study.width} × ${study.height} pixels, ${study.points.length} settings, on ${study.device}`;
  const reference = study.reference;
  const origin = reference.precision === null ? `the file ${reference.file}`
    : [reference.precision, reference.sampler, depthName(reference.max_depth), `${reference.spp} spp`].join(" · ") +
      `, rendered in ${seconds(reference.seconds)}`;
  const own = isNumber(reference.rmse)
    ? `its own RMSE is ${number(reference.rmse)} (95 %: ${range(reference.rmse_low, reference.rmse_high)})`
    : "its own error was not measured";
  const facts = [["Scene", study.scene], ["Device", study.device], ["Command", element("code", {}, study.command)],
    ["Version", `strahl ${study.strahl}`],
    ["Reference", `${origin}; ${own}`]];
  for (const [term, fact] of facts) byId("made").append(element("dt", {}, term), element("dd", {}, fact));
}

startTheme();
describe();
startFilters();
startPlot();
startPointing();
startSetting();
startPair();
startSheet();
startSlopes();
startSettings();
writeFindings();

const front = frontNow();
state.looked = (front[front.length >> 1] ?? study.points[0]).id;
for (const topic of Object.keys(listeners)) tell(topic);
