# SPDX-License-Identifier: GPL-3.0-or-later
"""A study's report in a browser: what its viewer shows and reads out, by mouse and by keys alone. Skipped (exit
code 77) where Debian's python3-selenium and chromium-driver are not installed."""

import base64
import csv
import datetime
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "export"))
try:
    import exr
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

DRIVER = "/usr/bin/chromedriver"
TITLE = "<!--<script> {{data}} </script><script>document.title = 'run'</script>"
PLY = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n0 0 {z}\n1 {tilt} {z}\n{tilt} 1 {z}\n3 0 1 2\n")


def make_report(folder, form):
    """A study of one small scene, a red sheet and a green one; returns its report."""
    for name, z, tilt in (("near", 0.2, 0.2), ("far", 0, 0)):
        (folder / f"{name}.ply").write_text(PLY.format(z=z, tilt=tilt))
    (folder / "sheets.json").write_text(json.dumps({
        "format": "pellucid-scene", "version": 1, "resolution": [96, 64],
        "objects": [{"mesh": "near.ply", "color": [0.9, 0.3, 0.1], "opacity": 0.4},
                    {"mesh": "far.ply", "color": [0.1, 0.8, 0.2], "opacity": 0.6}]}))
    (folder / "study.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": TITLE, "scenes": ["sheets.json"],
        "reference": "raytrace", "methods": ["weighted-average", "weighted-blended"], "repeats": 1}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "study.json", "-o", folder / form, "--report", form,
                    "--quiet"], check=True)
    return folder / form / "report.html"


def make_report_of_many(folder):
    """A study of one small scene by many methods, among them sweeps of a whole number and of a choice."""
    methods = ["raytrace:precision=double", "weighted-average", "linked-list", "mlab", "moment", {"method": "weighted-blended", "weight": ["7", "8", "9", "10"]},
               {"method": "fourier", "bands": [1, 2, 3, 4]}, {"method": "binning", "bins": [2, 3, 4, 5]}]
    (folder / "many.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": "Many", "scenes": ["sheets.json"],
        "reference": "raytrace", "methods": methods, "repeats": 1}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "many.json", "-o", folder / "many", "--quiet"], check=True)
    return folder / "many" / "report.html"


def make_report_of_given(folder):
    """A study of exact pictures that were made elsewhere: of one no costs are known, the other is said to cost nothing; a
    command that fails; and few methods, timed once. Each picture is of two views."""
    shutil.copy(folder / "file" / "images" / "sheets" / "raytrace.exr", folder / "exact.exr")
    (folder / "given.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": "Given", "scenes": ["sheets.json"], "reference": "raytrace",
        "methods": [{"picture": "exact.exr", "name": "theirs"}, {"picture": "exact.exr", "name": "free", "ms": 0, "bytes": 0},
                    {"external": "fails", "command": ["/bin/false", "{output}"]}, "weighted-average", "weighted-blended", "mlab",
                    {"method": "fourier", "bands": [1, 2]}], "repeats": 1}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "given.json", "-o", folder / "given", "--quiet"])
    return folder / "given" / "report.html"


def make_report_of_views(folder):
    """A study of one method from two sides."""
    (folder / "views.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": "Views", "scenes": ["sheets.json"],
        "reference": "raytrace", "methods": ["weighted-average"], "views": 2, "repeats": 1}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "views.json", "-o", folder / "views", "--quiet"], check=True)
    return folder / "views" / "report.html"


def start_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,900", "--no-first-run",
                     "--disable-background-networking", "--disable-component-update"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        cls.pages = {form: make_report(cls.folder, form) for form in ("file", "folder")}
        cls.many = make_report_of_many(cls.folder)
        cls.given = make_report_of_given(cls.folder)
        cls.views = make_report_of_views(cls.folder)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.place.cleanup()

    def open_viewer(self, form="file"):
        """Opens the viewer on the first method's picture, by the keyboard."""
        self.browser.get(self.pages[form].as_uri())
        buttons = self.browser.find_elements(By.CSS_SELECTOR, ".enlarge")
        buttons[1].send_keys(Keys.ENTER)
        self.wait_for("sheets · weighted-average")

    def wait_for(self, title):
        WebDriverWait(self.browser, 5, 0.02).until(lambda _: self.said().startswith(title) and self.title() == title)

    def title(self):
        return self.browser.find_element(By.CSS_SELECTOR, "dialog strong").text

    def said(self):
        return self.browser.find_element(By.CSS_SELECTOR, "dialog .readout").text

    def press(self, *keys, shift=False):
        actions = ActionChains(self.browser, duration=0)
        if shift:
            actions.key_down(Keys.SHIFT)
        for key in keys:
            actions.send_keys(key)
        if shift:
            actions.key_up(Keys.SHIFT)
        actions.perform()

    def seen(self):
        """Of the stage's canvas a hash (FNV-1a, by pixels) and the number of colours."""
        return tuple(self.browser.execute_script("""const c = document.querySelector("dialog canvas");
            const pixels = new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer);
            let hash = 2166136261;
            for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 16777619);
            return [hash >>> 0, new Set(pixels).size]"""))

    def console(self):
        """Without what is said of this test's own reading of the canvas."""
        return [entry["message"] for entry in self.browser.get_log("browser") if "willReadFrequently" not in entry["message"]]

    def test_the_read_out_is_the_value_of_the_exr(self):
        for form in self.pages:
            images = self.pages[form].parent / "images" / "sheets"
            truth, test = exr.read(images / "raytrace.exr"), exr.read(images / "weighted-average.exr")
            self.open_viewer(form)
            for _ in range(4):
                self.press(Keys.ARROW_LEFT, shift=True)
                words = self.said().replace(",", "").split()
                x, y = int(words[words.index("x") + 1]), int(words[words.index("y") + 1])
                for word, picture in (("colour", test), ("reference", truth)):
                    at = words.index(word)
                    for channel in range(3):
                        # Seven digits, half a unit of the last of them, and a float's own rounding.
                        self.assertAlmostEqual(float(words[at + 1 + channel]), float(picture[y, x, channel]), delta=1e-7)
            self.assertGreater(abs(float(test[y, x, 0]) - float(truth[y, x, 0])), 1e-3)  # which it would tell apart
            self.assertIn("the EXR's floats", self.said())
            self.assertEqual(words[words.index("layers") + 1], "2")
            self.assertEqual(self.console(), [])

    def test_what_is_not_known_of_a_given_picture_is_not_0(self):
        self.console()  # what others have left
        self.browser.get(self.given.as_uri())
        self.assertEqual(self.console(), [])
        row = self.browser.find_element(By.XPATH, "//section[@id='table']//tr[td[starts-with(., 'theirs')]]").text
        self.assertIn("–", row)
        self.assertNotIn("0.0", row.split())
        choices = [row.text for row in self.browser.find_elements(By.CSS_SELECTOR, "#choices tbody tr")]
        self.assertEqual(len(choices), 7)
        for choice in choices:
            self.assertIn("free; ", choice)  # which costs least of what is known
            self.assertIn("of unknown time: theirs", choice)
            self.assertIn("of unknown memory: theirs", choice)
        for title in ("Error against time", "Error against memory"):
            points = {line[0]: line[1:] for line in csv.reader(io.StringIO(self.saved(title, "CSV")))}
            self.assertNotIn("theirs", points)
            self.assertEqual(points["free"], ["0", "0", "true"])
            svg = self.saved(title, "SVG")
            self.assertRegex(svg, "Not drawn, of unknown error or [a-z]+: theirs")
            self.assertNotIn("NaN", svg)
        self.assertNotIn("theirs", self.saved("Where the time goes", "CSV"))

    def test_times_of_few_pictures_decide_nothing(self):
        self.browser.get(self.given.as_uri())
        choice = self.browser.find_element(By.CSS_SELECTOR, "#choices tbody tr").text
        self.assertIn("not told apart (fewer than five timed pictures): ", choice)
        heads = [head.text for head in self.browser.find_elements(By.CSS_SELECTOR, "#table th")]
        of = lambda name: {heads.index(cell.get_property("cellIndex") is not None and heads[cell.get_property("cellIndex")])
                           for cell in self.browser.find_elements(By.CSS_SELECTOR, f"#table td.{name}")}
        self.assertNotIn(heads.index("Time [ms]"), of("best"))
        self.assertEqual(of("undecided"), {heads.index("Time [ms]")})
        self.assertIn(heads.index("Memory [MB]"), of("best"))

    def test_equal_costs_are_named_ties(self):
        self.browser.get(self.many.as_uri())
        memory = self.browser.find_element(By.CSS_SELECTOR, "#choices tbody td:nth-child(5)").text
        sizes = {row["method"]: row["bytes"]["total"] for row in json.loads((self.many.parent / "results.json").read_text())["rows"]}
        self.assertEqual(sizes["raytrace"], min(sizes.values()))  # of double and float alike
        self.assertEqual(memory, "raytrace; tied: raytrace:precision=double")

    def test_what_is_not_known_is_sorted_last_both_ways(self):
        self.browser.get(self.given.as_uri())
        button = [b for b in self.browser.find_elements(By.CSS_SELECTOR, "#table th button") if b.text.startswith("Time")][0]
        for direction in ("ascending", "descending"):
            button.send_keys(Keys.ENTER)
            self.assertEqual(button.find_element(By.XPATH, "..").get_attribute("aria-sort"), direction)
            names = [row.find_elements(By.TAG_NAME, "td")[1].text for row in self.browser.find_elements(By.CSS_SELECTOR, "#table tbody tr")]
            self.assertEqual(set(names[-2:]), {"theirs (given)", "fails (given)"})

    def test_the_reference_is_not_headed_by_a_methods_errors(self):
        self.open_viewer()
        numbers = lambda: self.browser.find_element(By.CSS_SELECTOR, "dialog .heading span").text
        self.assertIn("RMSE", numbers())
        self.press("2")
        self.wait_for("sheets · raytrace")
        self.assertEqual(numbers(), "reference")

    def test_the_split_has_a_dividing_line(self):
        self.open_viewer()
        self.press("s")
        colors = self.browser.execute_script("""const c = document.querySelector("dialog canvas"), x = Math.round(c.width / 2);
            return [x - 1, x, x + 1].map((at) => [...c.getContext("2d").getImageData(at, 5, 1, 1).data].slice(0, 3))""")
        self.assertEqual(colors, [[255] * 3, [0] * 3, [255] * 3])

    def test_with_views_it_says_of_which_pictures_and_numbers_are(self):
        self.browser.get(self.views.as_uri())
        self.assertIn("are of view 1 of 2; numbers are means over the views", self.browser.find_element(By.CSS_SELECTOR, "section .lead").text)
        captions = [c.text for c in self.browser.find_elements(By.CSS_SELECTOR, "figcaption header")]
        self.assertTrue(all("view 1 of 2" in caption for caption in captions), captions)
        self.browser.find_elements(By.CSS_SELECTOR, ".enlarge")[1].send_keys(Keys.ENTER)
        self.wait_for("sheets · weighted-average · view 1 of 2")
        self.assertIn("means over 2 views: ", self.browser.find_element(By.CSS_SELECTOR, "dialog .heading span").text)
        self.assertIn("Of view 1 of 2", self.saved("Error over the number of layers, view 1", "SVG"))
        self.assertIn("means over 2 views", (self.views.parent / "table.md").read_text())
        figure = self.folder / "views.tex"
        subprocess.run([os.environ["PELLUCID_PROGRAM"], "figure", self.views.parent, "-o", figure], check=True, stdout=subprocess.DEVNULL)
        self.assertIn("Pictures are of view 1 of 2, numbers means over the views.", figure.read_text())

    def test_what_is_far_away_waits(self):
        self.browser.get(self.many.as_uri())
        drawn = lambda: self.browser.execute_script("return document.querySelectorAll('.plot svg').length")
        plots = self.browser.execute_script("return document.querySelectorAll('.plot').length")
        self.assertLess(drawn(), plots)
        for plot in self.browser.find_elements(By.CSS_SELECTOR, ".plot"):
            self.browser.execute_script("arguments[0].scrollIntoView({ behavior: 'instant' })", plot)
            WebDriverWait(self.browser, 5, 0.02).until(lambda _: plot.find_elements(By.TAG_NAME, "svg"))
        images = self.browser.execute_script("""document.querySelector(".card:last-child").scrollIntoView({ behavior: "instant" });
            return document.querySelectorAll(".card img").length""")
        WebDriverWait(self.browser, 5, 0.02).until(lambda _: self.browser.execute_script(
            "return [...document.querySelectorAll('.card:last-child img')].every((i) => i.naturalWidth > 0)"))
        self.assertGreater(images, 0)

    def test_each_plot_and_each_button_has_a_name_of_its_own(self):
        self.browser.get(self.many.as_uri())
        self.draw_all()
        names = self.browser.execute_script("return [...document.querySelectorAll('.plot [role=graphics-document]')].map((s) => s.getAttribute('aria-label'))")
        self.assertGreater(len(names), 4)
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("Error against time, sheets", names)
        buttons = [b.accessible_name for b in self.browser.find_elements(By.CSS_SELECTOR, ".enlarge")]
        self.assertEqual(len(buttons), len(set(buttons)))
        self.assertIn("Enlarge fourier:bands=2", buttons)

    def draw_all(self):
        for plot in self.browser.find_elements(By.CSS_SELECTOR, ".plot"):
            self.browser.execute_script("arguments[0].scrollIntoView({ behavior: 'instant' })", plot)
            WebDriverWait(self.browser, 5, 0.02).until(lambda _: plot.find_elements(By.CSS_SELECTOR, "svg g"))

    def test_labels_stand_at_their_own_points(self):
        seen = 0
        for page in (self.many, self.given):
            self.browser.get(page.as_uri())
            self.draw_all()
            for title in ("Error against time", "Error against memory"):
                labels, points = self.browser.execute_script("""
                    const plot = [...document.querySelectorAll(".plot")].find((p) => p.querySelector("h3").firstChild.data === arguments[0]);
                    const box = (e) => { const b = e.getBoundingClientRect(); return [b.left, b.top, b.right, b.bottom]; };
                    const points = [...plot.querySelectorAll(".mark-symbol path")].map((p) => [p.getAttribute("aria-label"), box(p)]);
                    const names = new Set(points.map(([tip]) => tip.split(": RMSE")[0]));
                    const texts = [...plot.querySelectorAll(".mark-text text")].filter((t) => names.has(t.textContent));
                    return [texts.map((t) => [t.textContent, box(t)]), points]""", title)
                seen += len(labels)
                for name, (left, top, right, bottom) in labels:
                    gaps = {}
                    for tip, box in points:
                        x, y = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
                        gaps[tip] = (max(left - x, 0, x - right) ** 2 + max(top - y, 0, y - bottom) ** 2) ** 0.5
                    own = [gap for tip, gap in gaps.items() if tip.startswith(f"{name}: RMSE")]
                    others = [gap for tip, gap in gaps.items() if not tip.startswith(f"{name}: RMSE")]
                    self.assertLess(own[0], 10, (title, name))
                    # Text may be measured some pixels smaller than it is.
                    self.assertTrue(all(gap > own[0] + 2 for gap in others), (title, name, gaps))
        self.assertGreater(seen, 3)

    def test_of_many_curves_the_numbers_are_all_kept(self):
        self.browser.get(self.many.as_uri())
        rows = json.loads((self.many.parent / "results.json").read_text())["rows"]
        of = {row["method"] + (":" + row["parameters"] if row["parameters"] else "") for row in rows if not row["reference"]}
        title = "Error over the number of layers"
        lines = list(csv.reader(io.StringIO(self.saved(title, "CSV"))))
        self.assertEqual({line[0] for line in lines[1:]}, of)
        self.assertIn(f"6 of {len(of)} curves are drawn; the CSV has all.", self.saved(title, "SVG"))

    def test_tables_have_their_heads_on_each_sheet(self):
        self.browser.get(self.many.as_uri())
        self.browser.execute_script("""const style = document.createElement("style");
            style.textContent = "@page { size: 210mm 90mm !important; }";
            document.head.append(style)""")
        text = subprocess.run(["pdftotext", "-layout", self.printed("low"), "-"], check=True, capture_output=True, text=True).stdout
        sheets = [sheet for sheet in text.split("\f") if re.search(r"^ *sheets +[a-z]", sheet, re.MULTILINE)]
        self.assertGreaterEqual(len(sheets), 3)
        for sheet in sheets:
            self.assertRegex(sheet, "Scene +(Method|RMSE)")

    def printed(self, name):
        """The page that is open, on paper."""
        pdf = self.folder / f"{name}.pdf"
        pdf.write_bytes(base64.b64decode(self.browser.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})["data"]))
        return pdf

    @staticmethod
    def images_of(pdf):
        return len(subprocess.run(["pdfimages", "-list", pdf], check=True, capture_output=True, text=True).stdout.splitlines()) - 2

    def test_pictures_beside_the_page_are_printed_too(self):
        counts = {}
        # Cards below each other, of which the last ones are far away.
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 300, "deviceScaleFactor": 1, "mobile": False})
        try:
            for form, page in self.pages.items():
                self.browser.get(page.as_uri())
                counts[form] = self.images_of(self.printed(form))
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.assertGreaterEqual(counts["file"], 8)  # of two methods picture, zoom-in and maps
        self.assertEqual(counts["file"], counts["folder"])

    def test_nothing_is_cut_off_on_paper(self):
        self.browser.get(self.many.as_uri())
        heads = [head.text for head in self.browser.find_elements(By.CSS_SELECTOR, "#table th")]
        names = {row.find_elements(By.TAG_NAME, "td")[1].text for row in self.browser.find_elements(By.CSS_SELECTOR, "#table tbody tr")}
        pdf = self.printed("many")
        info = subprocess.run(["pdfinfo", pdf], check=True, capture_output=True, text=True).stdout
        self.assertRegex(info, r"Page size: +59\d(\.\d+)? x 84\d")
        words = [tuple(map(float, w)) for w in re.findall(r'xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)"', subprocess.run(
            ["pdftotext", "-bbox", pdf, "-"], check=True, capture_output=True, text=True).stdout)]
        self.assertLessEqual(max(x for _, _, x in words), 595.3 - 20)  # all within the margins
        text = subprocess.run(["pdftotext", "-layout", pdf, "-"], check=True, capture_output=True, text=True).stdout
        flat = " ".join(subprocess.run(["pdftotext", pdf, "-"], check=True, capture_output=True, text=True).stdout.split())
        for head in heads:
            self.assertIn(head.split(" [")[0].split(",")[0], flat, head)
        for name in names:  # in the first columns' lines, in those of the others, and below its picture or in a plot
            self.assertGreaterEqual(text.count(name), 2, name)
        self.assertGreaterEqual(self.images_of(pdf), 3 * (len(names) - 1))
        # Afterwards it is as it was.
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".groups, .split"), [])
        self.assertEqual(self.console(), [])

    def test_zoom_and_place_stay_while_pictures_are_flipped(self):
        self.open_viewer()
        canvas = self.browser.find_element(By.CSS_SELECTOR, "dialog canvas")
        self.browser.execute_script("""const c = arguments[0], box = c.getBoundingClientRect();
            c.dispatchEvent(new WheelEvent("wheel", { deltaY: -300, clientX: box.x + 300, clientY: box.y + 200, cancelable: true }))""", canvas)
        ActionChains(self.browser, duration=0).drag_and_drop_by_offset(canvas, 60, -40).perform()
        before = self.seen()
        self.press("2")
        self.wait_for("sheets · raytrace")
        reference = self.seen()
        self.assertNotEqual(before, reference)
        for key, title in (("3", "error of weighted-average"), ("4", "difference of weighted-average"),
                           ("5", "FLIP of weighted-average"), (Keys.ARROW_RIGHT, "FLIP of weighted-blended"),
                           (Keys.ARROW_LEFT, "FLIP of weighted-average"), ("1", "weighted-average")):
            self.press(key)
            self.wait_for(f"sheets · {title}")
        self.assertEqual(self.seen(), before)
        self.press("0")
        self.assertNotEqual(self.seen(), before)

    def test_pixels_are_squares_of_one_colour(self):
        self.open_viewer()
        scale = self.browser.execute_script("return document.querySelector('dialog canvas').width / 96")
        self.assertGreater(scale, 2)  # the whole picture fits at more than twice its size
        picture = self.browser.execute_script("return document.querySelector('.card:nth-child(2) .frame img').naturalWidth")
        self.assertEqual(picture, 96)
        smooth = self.browser.execute_script("""const c = document.querySelector("dialog canvas");
            return c.getContext("2d").imageSmoothingEnabled""")
        self.assertFalse(smooth)
        self.assertLess(self.seen()[1], 400)  # a filter blends thousands more between the picture's own

    def test_the_split_shows_both(self):
        self.open_viewer()
        method = self.seen()
        self.press("2")
        self.wait_for("sheets · raytrace")
        reference = self.seen()
        self.press("1")
        self.wait_for("sheets · weighted-average")
        self.press("s")
        divider = self.browser.find_element(By.CSS_SELECTOR, "dialog .divider")
        self.assertTrue(divider.is_displayed())
        self.assertNotIn(self.seen(), (method, reference))
        divider.send_keys(Keys.END)
        self.assertEqual(self.seen(), reference)
        divider.send_keys(Keys.HOME)
        self.assertEqual(self.seen(), method)

    def test_everything_in_the_viewer_has_a_name(self):
        self.open_viewer()
        nameless = self.browser.execute_script("""return [...document.querySelectorAll(
            "dialog button, dialog input, dialog select, dialog canvas")].filter(
            (e) => !(e.getAttribute("aria-label") || e.textContent.trim())).map((e) => e.outerHTML)""")
        self.assertEqual(nameless, [])
        self.assertEqual(self.browser.execute_script("return document.activeElement.tagName"), "CANVAS")

    def test_a_title_stays_a_title(self):
        for page in self.pages.values():
            self.browser.get(page.as_uri())
            self.assertEqual(self.browser.title, TITLE)
            self.assertEqual(self.browser.find_element(By.TAG_NAME, "h1").text, TITLE)
            self.assertEqual(self.console(), [])

    def test_nothing_is_wider_than_a_narrow_window(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        try:
            self.open_viewer()
            for element in ("document.documentElement", "document.querySelector('dialog')"):
                width = self.browser.execute_script(f"return {element}.scrollWidth")
                self.assertLessEqual(width, 390, element)
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def saved(self, title, kind):
        """The text of the file that a plot's button saves."""
        return self.browser.execute_async_script("""
            const [title, kind, done] = arguments;
            const plot = [...document.querySelectorAll(".plot")].find((p) => p.querySelector("h3").firstChild.data === title);
            const create = URL.createObjectURL;
            URL.createObjectURL = (blob) => { URL.createObjectURL = create; blob.text().then(done); return "#"; };
            [...plot.querySelectorAll("button")].find((b) => b.textContent === kind).click();""", title, kind)

    @staticmethod
    def texts(svg):
        """Each text of a drawing, and each line of those that have several."""
        return [node.firstChild.data for tag in ("text", "tspan") for node in svg.getElementsByTagName(tag)
                if node.firstChild and node.firstChild.nodeType == node.TEXT_NODE]

    def test_a_plot_is_saved_as_svg_and_as_the_numbers_that_it_shows(self):
        self.browser.get(self.many.as_uri())
        rows = json.loads((self.many.parent / "results.json").read_text())["rows"]
        rmse = {row["method"] + ":" + row["parameters"] if row["parameters"] else row["method"]: row["metrics"]["rmse"]
                for row in rows if not row["reference"]}
        lines = list(csv.reader(io.StringIO(self.saved("Error against time", "CSV"))))
        self.assertEqual(lines[0], ["name", "ms", "RMSE", "on the front"])
        self.assertEqual({line[0]: float(line[2]) for line in lines[1:]}, rmse)
        svg = xml.dom.minidom.parseString(self.saved("Error against time", "SVG"))
        self.assertEqual(svg.documentElement.tagName, "svg")
        # Of so many points only those of the front have their names.
        names = set(self.texts(svg))
        front = {line[0] for line in lines[1:] if line[3] == "true"}
        self.assertLessEqual(names & set(rmse), front)
        # Those without room for their names are named below.
        for name in front:
            self.assertTrue(any(name in text for text in names), name)
        self.assertEqual(self.console(), [])

    def test_choices_are_no_scale_and_whole_numbers_have_whole_ticks(self):
        self.browser.get(self.many.as_uri())
        ticks = lambda title: self.texts(xml.dom.minidom.parseString(self.saved(title, "SVG")))
        self.assertEqual(ticks("weighted-blended: RMSE over weight")[:4], ["7", "8", "9", "10"])
        self.assertEqual(ticks("fourier: RMSE over bands")[:4], ["1", "2", "3", "4"])
        self.assertFalse([t for t in ticks("fourier: ms over bands") if "e+" in t])

    def test_the_table_is_filtered_by_words(self):
        self.browser.get(self.many.as_uri())
        shown = lambda: [row.find_elements(By.TAG_NAME, "td")[1].text
                         for row in self.browser.find_elements(By.CSS_SELECTOR, "#table tbody tr")]
        everything = shown()
        field = self.browser.find_element(By.CSS_SELECTOR, ".filter input")
        field.send_keys("Fourier sheets")
        self.assertEqual(shown(), [name for name in everything if name.startswith("fourier")])
        # Sorted, it stays filtered. By its key: plots that are drawn meanwhile move what a mouse aims at.
        self.browser.find_element(By.CSS_SELECTOR, "#table th button").send_keys(Keys.ENTER)
        self.assertEqual(len(shown()), 4)
        field.clear()
        field.send_keys(" ")
        self.assertEqual(len(shown()), len(everything))
        self.browser.get(self.pages["file"].as_uri())
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".filter input"), [])

    def test_the_table_is_filtered_by_bounds_on_numbers(self):
        self.browser.get(self.many.as_uri())
        rows = json.loads((self.many.parent / "results.json").read_text())["rows"]
        field = self.browser.find_element(By.CSS_SELECTOR, ".filter input")
        bound = sorted(row["metrics"]["rmse"] for row in rows)[len(rows) // 2]
        field.send_keys(f"binning rmse<={bound!r}")
        shown = self.browser.find_elements(By.CSS_SELECTOR, "#table tbody tr")
        within = [row for row in rows if row["method"] == "binning" and row["metrics"]["rmse"] <= bound]
        self.assertEqual(len(shown), len(within))
        field.clear()
        field.send_keys("memory<0")
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "#table tbody tr"), [])

    def test_provenance_has_texts_hashes_dates_and_cameras(self):
        self.browser.get(self.pages["file"].as_uri())
        section = self.browser.find_element(By.ID, "provenance")
        texts = self.browser.execute_script("return [...document.querySelectorAll('#provenance pre')].map((e) => e.textContent)")
        self.assertEqual(texts, [(self.folder / name).read_text() for name in ("study.json", "sheets.json")])
        rows = json.loads((self.pages["file"].parent / "results.json").read_text())["rows"]
        for file, content in rows[0]["files_read"].items():
            self.assertIn(content, section.find_element(By.XPATH, f".//dt[.='{file}']/following-sibling::dd").text)
        measured = section.find_element(By.XPATH, ".//dt[.='measured']/following-sibling::dd").text
        at = rows[0]["seconds"]["calibrations"][0]["at"]
        self.assertIn(datetime.datetime.fromtimestamp(at, datetime.timezone.utc).strftime("%Y-%m-%d %H:%M"), measured)
        camera = section.find_element(By.XPATH, ".//dt[.='--camera']/following-sibling::dd").text
        again = self.folder / "again.exr"
        subprocess.run([os.environ["PELLUCID_PROGRAM"], "render", self.folder / "sheets.json", "-m", "raytrace", "-o", again,
                        "--camera", camera, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        first = exr.read(self.pages["file"].parent / "images" / "sheets" / "raytrace.exr")
        self.assertLess(abs(exr.read(again) - first).max(), 1e-5)

    def copied(self, kind):
        return self.browser.execute_async_script("""const [kind, done] = arguments;
            Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text) => done(text) } });
            [...document.querySelectorAll(".copies button")].find((b) => b.textContent === kind).click()""", kind)

    def test_the_table_is_copied_as_it_is_shown(self):
        self.browser.get(self.given.as_uri())
        rows = json.loads((self.given.parent / "results.json").read_text())["rows"]
        lines = list(csv.DictReader(io.StringIO(self.copied("CSV"))))
        self.assertEqual([line["Method"] for line in lines], [
            row["method"] + (":" + row["parameters"] if row["parameters"] else "") + (" (given)" if row.get("given") else "") for row in rows])
        for line, row in zip(lines, rows):
            if "error" in row:
                self.assertIn("ended with code 1", line["Error"])
            else:
                self.assertEqual(float(line["RMSE"]), row["metrics"]["rmse"])
        self.assertEqual(lines[1]["Memory [MB]"], "")  # not known
        markdown = self.copied("Markdown").splitlines()
        self.assertEqual(len(markdown), len(rows) + 2)
        self.assertTrue(markdown[2].startswith("| sheets | raytrace | 0 | 1 | ∞ |"), markdown[2])
        latex = self.copied("LaTeX")
        self.assertIn("sheets & theirs (given) & {\\boldmath\\textbf{0}} & ", latex)
        self.assertIn("& $\\infty$ &", latex)
        self.assertIn("\\multicolumn{", latex)
        self.assertEqual(self.console(), [])


if __name__ == "__main__":
    unittest.main()
