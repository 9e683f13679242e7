#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The report in headless Chromium, used as a reader uses it. report_browser.py PAGE.html|PROGRAM [SCREENSHOTS]

PROGRAM writes a page to the path that it is given (sample_report). Needs Debian's chromium, chromium-driver and
python3-selenium; exits 77 where one of them is missing. SCREENSHOTS: a folder for pictures to be looked at.
"""
import base64
import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    webdriver = None

FORMAT = pathlib.Path(__file__).resolve().parents[2] / "src/study/report/format.js"
LUMINANCE = """
const canvas = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
const bytes = (colour) => {
  canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1);
  return [...canvas.getImageData(0, 0, 1, 1).data];
};
const luminance = (rgb) => [0.2126, 0.7152, 0.0722].reduce((sum, weight, i) => {
  const c = rgb[i] / 255;
  return sum + weight * (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
}, 0);
const behind = (node) => {
  for (let at = node; at; at = at.parentElement) {
    const colour = bytes(getComputedStyle(at).backgroundColor);
    if (colour[3] > 100) return colour;
  }
  throw new Error("nothing is behind " + node.outerHTML);
};
return [...document.querySelectorAll(arguments[0])].map((node) => {
  const pair = [luminance(bytes(getComputedStyle(node)[arguments[1]])), luminance(behind(node))];
  return (Math.max(...pair) + 0.05) / (Math.min(...pair) + 0.05);
});
"""


def open_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    options.add_argument("--headless=new")
    options.add_argument("--force-device-scale-factor=1")
    options.add_argument("--disable-dev-shm-usage")
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


class Report(unittest.TestCase):
    page = None
    screenshots = None

    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        self.opened = set()
        self.show(1280, "light")

    def tearDown(self):
        """Whatever a test did: nothing went wrong in the page, and nothing was asked for but the page."""
        self.assertEqual([entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"], [])
        events = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        urls = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
        self.assertIn(self.page.as_uri(), urls)
        self.assertEqual([url[:80] for url in urls if url not in self.opened and not url.startswith("data:")], [])
        self.run_script("localStorage.clear()")

    def show(self, width, scheme, height=900):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": scheme}]})
        self.open_page(self.page)

    def open_page(self, page):
        self.opened.add(page.as_uri())
        self.browser.get(page.as_uri())

    @contextlib.contextmanager
    def page_of(self, study):
        """The page with another study in it."""
        text, whole = self.page.read_text(), self.page
        start = text.index(">", text.index('<script type="application/json" id="study"')) + 1
        with tempfile.NamedTemporaryFile("w", suffix=".html") as part:
            part.write(text[:start] + json.dumps(study) + text[text.index("</script>", start):])
            part.flush()
            self.page = pathlib.Path(part.name)
            try:
                self.show(1280, "light")
                yield
            finally:
                self.page = whole

    def run_script(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        """With plain spaces."""
        found = "return [...document.querySelectorAll(arguments[0])].map((node) => node.textContent.trim())"
        return [text.replace("\u00a0", " ") for text in self.run_script(found, selector)]

    def study(self):
        return json.loads(self.run_script("return document.getElementById('study').textContent"))

    def mark(self, point):
        return self.find(f'#drawing [data-id="{point["id"]}"]')

    def look_at(self, point):
        mark = self.mark(point)
        self.run_script("arguments[0].scrollIntoView({block: 'center'})", mark)
        ActionChains(self.browser).move_to_element(mark).perform()

    def lonely_points(self):
        """Points whose mark is nobody's neighbour, so that pointing is not ambiguous."""
        return self.run_script("""
            const marks = [...document.querySelectorAll("#drawing [data-id]")].map((mark) => {
              const box = mark.getBoundingClientRect();
              return {id: mark.dataset.id, x: box.x + box.width / 2, y: box.y + box.height / 2};
            });
            const gap = (mark) => Math.min(...marks.filter((other) => other !== mark)
              .map((other) => Math.hypot(other.x - mark.x, other.y - mark.y)));
            const all = JSON.parse(document.getElementById("study").textContent).points;
            return marks.map((mark) => [gap(mark), mark.id]).sort((a, b) => b[0] - a[0])
              .map(([, id]) => all.find((point) => point.id === id));""")

    def screenshot(self, name):
        if self.screenshots:
            height = self.run_script("return document.documentElement.scrollHeight")
            image = self.browser.execute_cdp_cmd("Page.captureScreenshot", {
                "captureBeyondViewport": True,
                "clip": {"x": 0, "y": 0, "width": self.run_script("return innerWidth"), "height": height, "scale": 1}})
            (self.screenshots / f"{name}.png").write_bytes(base64.b64decode(image["data"]))

    def test_plot_shows_every_point(self):
        study = self.study()
        drawn = {mark.get_attribute("data-id") for mark in self.find_all("#drawing [data-id]")}
        self.assertEqual(drawn, {point["id"] for point in study["points"]})
        self.assertEqual(len(self.find_all("#drawing .front")), 1)
        self.assertGreaterEqual(len(self.texts("#drawing .axis text")), 8)
        self.assertEqual(len(self.find_all("#drawing .series .curve")), len(study["fits"]))
        self.assertEqual(len(self.find_all("#slopes tbody tr")), len(study["fits"]))
        lines = lambda: len([line for line in self.find_all("#drawing .fit") if line.is_displayed()])
        self.assertEqual(lines(), 0)
        self.find("#draw-fits").click()
        self.assertEqual(lines(), len(study["fits"]))
        self.assertGreaterEqual(len(self.find_all("#findings li")), 3)

    def test_front_is_that_of_the_study(self):
        front = {point["id"] for point in self.study()["points"] if point["pareto"]}
        self.find("#front-only").click()
        rows = {row.get_attribute("data-id") for row in self.find_all("#settings tbody tr")}
        self.assertEqual(rows, front)
        self.assertEqual({mark.get_attribute("data-id") for mark in self.find_all("#drawing [data-id]")}, front)

    def test_other_axes(self):
        offered = [choice.get_attribute("value") for choice in Select(self.find("#measure")).options]
        self.assertIn("relmse", offered)
        for measure in offered:
            Select(self.find("#measure")).select_by_value(measure)
            self.assertGreater(len(self.find_all("#drawing [data-id]")), 0)
            self.assertNotIn("NaN", self.find("#plot").get_attribute("innerHTML"))
        before = self.texts("#drawing .axis .title")
        Select(self.find("#time")).select_by_value("wall")
        self.assertNotEqual(before, self.texts("#drawing .axis .title"))

    def test_hover_shows_setting_and_picture(self):
        for point in self.lonely_points()[:3]:
            self.look_at(point)
            self.assertEqual(len(self.find_all("#drawing .label")), 1)
            label, heading = self.texts("#drawing .label tspan"), self.texts("#setting h3")[0]
            self.assertEqual(heading, f"{label[0]} · {point['spp']} spp")
            self.assertTrue(label[1].startswith(f"{point['spp']} spp · "), label[1])
            self.assertIn(point["precision"], heading)
            shown = self.find("#setting img")
            self.assertTrue(self.run_script(
                "const uris = JSON.parse(document.getElementById('pictures').textContent);"
                "return arguments[0].src === uris[arguments[1]]", shown, point["picture"]))
            self.assertGreater(shown.get_property("naturalWidth"), 0)
        ActionChains(self.browser).move_to_element(self.find("h1")).perform()
        self.assertEqual(self.find_all("#drawing .label"), [])

    def test_click_pins_and_unpins(self):
        point, other = self.lonely_points()[:2]
        for chosen in (point, other):
            self.look_at(chosen)
            ActionChains(self.browser).click().perform()
        self.assertEqual(self.mark(point).get_attribute("aria-pressed"), "true")
        self.assertEqual(len(self.find_all("#pins button")), 2)
        self.assertEqual(self.texts("#drawing .pin text"), ["B", "A"])
        self.assertEqual(Select(self.find("#left")).first_selected_option.get_attribute("value"), other["id"])
        Select(self.find("#right")).select_by_value(point["id"])
        self.assertIn("RMSE", self.find("#pair-note").text)
        self.assertEqual(len(self.find_all("#differences img")), 2)
        self.find("#pins button").click()
        self.assertEqual(self.mark(point).get_attribute("aria-pressed"), "false")

    def test_keyboard_walks_and_pins(self):
        self.look_at(self.lonely_points()[0])  # a pointer that rests on the plot does not take the look away
        self.run_script("[...document.querySelectorAll('#choices input')].at(-1).focus()")
        ActionChains(self.browser).send_keys(Keys.TAB).perform()
        here = "return document.activeElement.dataset.id"
        first = self.run_script(here)
        self.assertIsNotNone(first)
        places = [first]
        for key in (Keys.HOME, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_DOWN, Keys.END):
            ActionChains(self.browser).send_keys(key).perform()
            places.append(self.run_script(here))
        self.assertEqual(len(self.find_all("#drawing .label")), 1)
        self.assertEqual(self.texts("#setting h3"),
                         [self.run_script("return document.activeElement.ariaLabel").split(":")[0].replace("\u00a0", " ")])
        points = {point["id"]: point for point in self.study()["points"]}
        self.assertLess(points[places[1]]["spp"], points[places[3]]["spp"])
        self.assertEqual(points[places[3]]["spp"], points[places[4]]["spp"])
        self.assertNotEqual(places[3].split("-")[:3], places[4].split("-")[:3])
        ActionChains(self.browser).send_keys(Keys.ENTER).perform()
        self.assertEqual(self.run_script(here), places[-1])
        self.assertEqual(self.run_script("return document.activeElement.getAttribute('aria-pressed')"), "true")
        self.assertIn("pinned as A", self.run_script("return document.activeElement.getAttribute('aria-label')"))
        ActionChains(self.browser).send_keys(" ").perform()
        self.assertEqual(self.run_script("return document.activeElement.getAttribute('aria-pressed')"), "false")

    def test_slider_moves_the_cut(self):
        cut = "return getComputedStyle(document.querySelector('#pair img.left')).clipPath"
        slider = self.find("#slider")
        before, place = self.run_script(cut), float(slider.get_property("value"))
        slider.send_keys(Keys.ARROW_RIGHT * 5)
        self.assertGreater(float(slider.get_property("value")), place)
        self.assertNotEqual(self.run_script(cut), before)
        pair = self.find("#pair")
        ActionChains(self.browser).move_to_element_with_offset(pair, -pair.size["width"] // 4, 0).click().perform()
        self.assertAlmostEqual(float(slider.get_property("value")), 25, delta=1)
        self.assertIn("25 %", slider.get_attribute("aria-valuetext"))
        sizes = self.run_script("return [...document.querySelectorAll('#pair img')].map((i) => i.naturalWidth)")
        self.assertEqual(sizes, [self.study()["width"]] * 2)

    def test_table_sorts(self):
        points = {point["id"]: point for point in self.study()["points"]}
        for key, value in [("rmse", lambda point: point["rmse"]), ("wall", lambda point: point["seconds"]["wall"]),
                           ("spp", lambda point: point["spp"])]:
            for direction in ("ascending", "descending"):
                self.find(f'#settings th[data-key="{key}"] button').click()
                self.assertEqual(self.find(f'#settings th[data-key="{key}"]').get_attribute("aria-sort"), direction)
                values = [value(points[row.get_attribute("data-id")]) for row in self.find_all("#settings tbody tr")]
                self.assertEqual(values, sorted(values, reverse=direction == "descending"))
        self.assertEqual(len(self.find_all('#settings th[aria-sort$="ending"]')), 1)

    def test_filters_hold_everywhere(self):
        robust = [point for point in self.study()["points"] if point["precision"] == "robust"]
        Select(self.find('#settings select[data-axis="precision"]')).select_by_visible_text("robust")
        for selector in ("#settings tbody tr", "#drawing [data-id]", "#sheet button"):
            self.assertEqual(len(self.find_all(selector)), len(robust), selector)
        self.assertIn(f"{len(robust)} of", self.find("#shown").text)
        next(label for label in self.find_all("#filters label") if "robust" in label.text).click()
        self.assertEqual(self.find_all("#drawing [data-id]"), [])
        self.assertIn("No setting is left to draw", self.texts("#plot-note")[0])
        self.find("#show-all").click()
        self.assertEqual(len(self.find_all("#drawing [data-id]")), len(self.study()["points"]))

    def test_theme_follows_the_system_until_told(self):
        background = "return getComputedStyle(document.documentElement).backgroundColor"
        light = self.run_script(background)
        self.show(1280, "dark")
        dark = self.run_script(background)
        self.assertNotEqual(light, dark)
        self.find("#theme").click()
        self.assertEqual(self.run_script(background), light)
        self.open_page(self.page)
        self.assertEqual(self.run_script(background), light)

    def test_fits_every_width(self):
        for scheme in ("light", "dark"):
            for width in (400, 760, 1280, 1600):
                self.show(width, scheme)
                self.look_at(self.lonely_points()[0])
                if width not in (760, 1600):
                    ActionChains(self.browser).click().perform()
                wide = self.run_script("return [document.documentElement.scrollWidth, innerWidth]")
                self.assertLessEqual(wide[0], wide[1], f"{width} pixels, {scheme}")
                self.screenshot(f"{width}-{scheme}")

    def test_contrast(self):
        for scheme in ("light", "dark"):
            self.show(1280, scheme)
            for selector, paint, least in [
                    ("h1, p, li, label, legend, button, select, dt, dd, th, td, small, figcaption, a", "color", 4.5),
                    ("#drawing text", "fill", 4.5), ("#drawing .mark path:first-child", "stroke", 3)]:
                self.assertGreaterEqual(min(self.run_script(LUMINANCE, selector, paint)), least, f"{selector}, {scheme}")

    def test_everything_that_can_be_used_has_a_name(self):
        self.browser.execute_cdp_cmd("Accessibility.enable", {})
        nodes = self.browser.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
        used = [node for node in nodes if not node["ignored"] and node.get("role", {}).get("value") in
                {"button", "checkbox", "radio", "combobox", "slider", "link", "region", "image", "group", "table"}]
        self.assertGreater(len(used), 60)
        nameless = [node["role"]["value"] for node in used if not node.get("name", {}).get("value")]
        self.assertEqual([role for role in nameless if role not in {"image", "group"}], [])
        self.assertEqual(self.run_script("return [...document.images].filter((i) => !i.hasAttribute('alt')).length"), 0)

    def test_study_without_much(self):
        """One tier, one curve, no fits, no depth, a reference from a file, figures that could not be had."""
        study = self.study()
        study["fits"] = []
        study["points"] = [point for point in study["points"] if point["id"].startswith("robust-sobol-d8-")
                           and not point["generic"]]
        for point in study["points"]:
            point.update({"max_depth": None, "ssim": None, "flip": None, "psnr": None, "bias2": 0})
        study["points"][0].update({"rmse": 0, "rmse_low": 0, "rmse_high": 0, "mse": 0})
        study["reference"] = {key: None for key in study["reference"]} | {
            "file": "reference.exr", "picture": study["reference"]["picture"]}
        with self.page_of(study):
            self.assertEqual(len(self.find_all("#drawing [data-id]")), len(study["points"]) - 1)
            self.assertIn("1 of the settings", self.texts("#plot-note")[0])
            self.assertIn("reference.exr", self.texts("#made")[0])
            self.assertEqual([choice.get_attribute("value") for choice in Select(self.find("#measure")).options],
                             ["rmse", "relmse"])
            self.find('#settings th[data-key="flip"] button').click()
            self.assertEqual(len(self.find_all("#settings tbody tr")), len(study["points"]))
            self.assertNotIn("NaN", self.find("body").text)

    def test_three_samplers_look_different(self):
        study = self.study()
        study["fits"] = []
        study["points"] = [point for point in study["points"] if point["id"].startswith("robust-")
                           and not point["generic"]]
        for point in study["points"]:
            if point["max_depth"] == 2 and point["sampler"] == "sobol":
                point["sampler"] = "centre"
        with self.page_of(study):
            look = """return [...arguments[0].querySelectorAll("*")].map(
                (part) => part.tagName + " " + getComputedStyle(part).fill).join()"""
            looks = {(point["sampler"], self.run_script(look, self.mark(point))) for point in study["points"]}
            self.assertEqual([len(set(column)) for column in zip(*looks)], [3, 3])
            self.assertEqual(len(looks), 3)

    def test_numbers_are_rounded_before_they_are_told(self):
        text = FORMAT.read_text()
        told = self.run_script(text + "return [99.6, 1, 9.996e-8, -99.6].map((x) => number(x, 2))"
                                      ".concat([percent(0.996), times(99.7), number(999.6), number(0.00009996)],"
                                      " [0.9996, 9.996e-4, 0.0099].map((x) => seconds(x)))")
        self.assertEqual([part.replace("\u00a0", " ") for part in told],
                         ["100", "1.0", "10⁻⁷", "−100", "100 %", "100 ×", "1000", "0.000100",
                          "1.00 s", "1.00 ms", "9.90 ms"])

    def test_leaves_no_globals(self):
        names = "return Object.keys(window).sort()"
        ours = self.run_script(names)
        with tempfile.NamedTemporaryFile("w", suffix=".html") as blank:
            self.open_page(pathlib.Path(blank.name))
            self.assertEqual(ours, self.run_script(names))


def main():
    if webdriver is None or not shutil.which("chromium") or not shutil.which("chromedriver"):
        print("skipped: needs Debian's chromium, chromium-driver and python3-selenium")
        return 77
    source = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        Report.page = source
        if source.suffix != ".html":
            Report.page = pathlib.Path(folder).resolve() / "report.html"
            subprocess.run([source, Report.page], check=True)
        if len(sys.argv) > 2:
            Report.screenshots = pathlib.Path(sys.argv[2])
            Report.screenshots.mkdir(parents=True, exist_ok=True)
        tests = unittest.defaultTestLoader.loadTestsFromTestCase(Report)
        return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
