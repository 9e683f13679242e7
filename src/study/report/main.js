// SPDX-License-Identifier: MIT
// Lists the settings with their pictures.
const study = JSON.parse(document.getElementById("study").textContent);
const pictures = JSON.parse(document.getElementById("pictures").textContent);
const table = document.getElementById("table");
for (const point of study.points) {
  const row = table.insertRow();
  row.insertCell().textContent = point.id;
  row.insertCell().textContent = point.seconds.kernel;
  row.insertCell().textContent = point.rmse;
  const picture = new Image();
  picture.src = pictures[point.picture];
  picture.alt = point.id;
  row.insertCell().append(picture);
}
