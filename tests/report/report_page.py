# SPDX-License-Identifier: GPL-3.0-or-later
"""A study's report in a browser, for the tests beside this file. They are skipped (exit code 77) where Debian's
python3-selenium and chromium-driver are not installed."""

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
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

DRIVER = "/usr/bin/chromedriver"
TITLE = "<!--<script> {{data}} </script><script>document.title = 'run'</script>"
PLY = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n0 0 {z}\n1 {tilt} {z}\n{tilt} 1 {z}\n3 0 1 2\n")


def make_scene(folder):
    """A small scene, a red sheet and a green one."""
    for name, z, tilt in (("near", 0.2, 0.2), ("far", 0, 0)):
        (folder / f"{name}.ply").write_text(PLY.format(z=z, tilt=tilt))
    (folder / "sheets.json").write_text(json.dumps({
        "format": "pellucid-scene", "version": 1, "resolution": [96, 64],
        "objects": [{"mesh": "near.ply", "color": [0.9, 0.3, 0.1], "opacity": 0.4},
                    {"mesh": "far.ply", "color": [0.1, 0.8, 0.2], "opacity": 0.6}]}))


def make_report(folder, form):
    """A study of it by two methods; returns its report, a file or a folder."""
    (folder / "study.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": TITLE, "scenes": ["sheets.json"],
        "reference": "raytrace", "methods": ["weighted-average", "weighted-blended"], "repeats": 1}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "study.json", "-o", folder / form, "--report", form,
                    "--quiet"], check=True)
    return folder / form / "report.html"


def make_report_of_growth(folder):
    """A study of it in three sizes of its picture, with how costs grow."""
    scene = json.loads((folder / "sheets.json").read_text())
    sizes = {f"side-{side}": side * side for side in (32, 64, 128)}
    for (name, pixels), side in zip(sizes.items(), (32, 64, 128)):
        (folder / f"{name}.json").write_text(json.dumps({**scene, "resolution": [side, side]}))
    (folder / "growth.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": "Growth", "scenes": [f"{name}.json" for name in sizes],
        "reference": "raytrace", "methods": ["weighted-average", "linked-list"], "repeats": 1,
        "growth": [{"title": "Pixels", "scenes": sizes}]}))
    subprocess.run([os.environ["PELLUCID_PROGRAM"], "study", folder / "growth.json", "-o", folder / "growth", "--quiet"], check=True)
    return folder / "growth" / "report.html"


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
    """A study of two methods, one of them exact, from three sides."""
    (folder / "views.json").write_text(json.dumps({
        "format": "pellucid-study", "version": 1, "title": "Views", "scenes": ["sheets.json"],
        "reference": "raytrace", "methods": ["weighted-average", "linked-list"], "views": 3, "repeats": 1}))
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


class ReportPage(unittest.TestCase):
    """Reports in a browser: each is made when a test first asks for it."""

    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        cls.made = {}
        make_scene(cls.folder)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.place.cleanup()

    def report(self, name, make):
        if name not in self.made:
            self.made[name] = make(self.folder)
        return self.made[name]

    @property
    def pages(self):
        return {form: self.report(form, lambda folder: make_report(folder, form)) for form in ("file", "folder")}

    @property
    def many(self):
        return self.report("many", make_report_of_many)

    @property
    def growth(self):
        return self.report("growth", make_report_of_growth)

    @property
    def given(self):
        self.pages  # the pictures that were made elsewhere
        return self.report("given", make_report_of_given)

    @property
    def views(self):
        return self.report("views", make_report_of_views)

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

    def console(self):
        """Without what is said of this test's own reading of the canvas."""
        return [entry["message"] for entry in self.browser.get_log("browser") if "willReadFrequently" not in entry["message"]]

    def saved(self, title, kind):
        """The text of the file that a plot's button saves."""
        return self.browser.execute_async_script("""
            const [title, kind, done] = arguments;
            const plot = [...document.querySelectorAll(".plot")].find((p) => p.querySelector("h3").firstChild.data === title);
            const create = URL.createObjectURL;
            URL.createObjectURL = (blob) => { URL.createObjectURL = create; blob.text().then(done); return "#"; };
            [...plot.querySelectorAll("button")].find((b) => b.textContent === kind).click();""", title, kind)
