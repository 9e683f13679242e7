// SPDX-License-Identifier: MIT
// Light or dark: as the system has it until the button is pressed, then as it says, next time too.

const themeKey = "strahl-theme";
const systemIsDark = matchMedia("(prefers-color-scheme: dark)");

/// A browser may keep pages from storing anything; then the choice holds while the page is open.
function stored(action) {
  try {
    return action(localStorage);
  } catch (error) {
    if (error instanceof DOMException) return null;
    throw error;
  }
}

function themeNow() {
  return document.documentElement.dataset.theme ?? (systemIsDark.matches ? "dark" : "light");
}

function nameTheme() {
  byId("theme").textContent = themeNow() === "dark" ? "Light colours" : "Dark colours";
}

function startTheme() {
  const kept = stored((storage) => storage.getItem(themeKey));
  if (kept === "dark" || kept === "light") document.documentElement.dataset.theme = kept;
  nameTheme();
  systemIsDark.addEventListener("change", nameTheme);
  byId("theme").addEventListener("click", () => {
    const theme = themeNow() === "dark" ? "light" : "dark";
    document.documentElement.dataset.theme = theme;
    stored((storage) => storage.setItem(themeKey, theme));
    nameTheme();
  });
}
