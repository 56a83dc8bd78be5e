# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `pellucid view` in a browser: turning, methods, probing, saving, by mouse and by keys; who is refused; how
it ends. Skipped (exit code 77) where Debian's python3-selenium and chromium-driver are not installed."""

import http.client
import json
import math
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "report"))
from report_page import PLY, start_browser  # noqa: E402  (it skips where there is no browser)
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.support.ui import Select, WebDriverWait  # noqa: E402

PROGRAM = os.environ["PELLUCID_PROGRAM"]
LONGEST = 40  # seconds that a picture may take, on a machine that others share


def make_scene(folder):
    for name, z, tilt in (("near", 0.2, 0.2), ("far", 0, 0)):
        (folder / f"{name}.ply").write_text(PLY.format(z=z, tilt=tilt))
    file = folder / "sheets.json"
    file.write_text(json.dumps({
        "format": "pellucid-scene", "version": 1, "resolution": [96, 64],
        "camera": {"eye": [0.3, 0.3, 3], "target": [0.3, 0.3, 0], "fov": 30},
        "objects": [{"mesh": "near.ply", "color": [0.9, 0.3, 0.1], "opacity": 0.4},
                    {"mesh": "far.ply", "color": [0.1, 0.8, 0.2], "opacity": 0.6}]}))
    return file


class Server:
    """`pellucid view` of a file or a folder, ended by the end of its standard input."""

    def __init__(self, what, *options):
        self.process = subprocess.Popen([PROGRAM, "view", what, "--json", *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.address = json.loads(self.process.stdout.readline())["address"]
        url = urllib.parse.urlparse(self.address)
        self.port, self.path = url.port, url.path

    def end(self):
        """Returns the exit code."""
        self.process.stdin.close()
        self.process.stdout.close()
        return self.process.wait(10)

    def get(self, path, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=10)
        connection.request("GET", path, headers=headers)
        response = connection.getresponse()
        body = response.read()
        connection.close()
        return response.status, body

    def processor_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        cls.scene = make_scene(cls.folder)
        cls.study = cls.folder / "study.json"
        cls.study.write_text('{ "title": "mine" }')
        cls.server = Server(cls.scene, "--study", cls.study)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        code = cls.server.end()
        cls.place.cleanup()
        assert code == 0, code

    def setUp(self):
        self.browser.get(self.server.address)
        self.settle("raytrace")

    def settle(self, *words):
        """Waits for the picture with all samples, and for these words beside it."""
        WebDriverWait(self.browser, LONGEST, 0.02).until(
            lambda _: "16 samples" in self.numbers() and all(word in self.numbers() for word in words))

    def numbers(self):
        return self.browser.find_element(By.ID, "numbers").text

    def canvas(self):
        return self.browser.find_element(By.ID, "canvas")

    def control(self, name):
        return self.browser.find_element(By.CSS_SELECTOR, f'[aria-label="{name}"]')

    def button(self, text):
        return self.browser.find_element(By.XPATH, f"//button[.='{text}']")

    def seen(self):
        return self.browser.execute_script("""const c = document.getElementById("canvas");
            const pixels = new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer);
            let hash = 2166136261;
            for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 16777619);
            return hash >>> 0""")

    def changed(self, before):
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: self.seen() != before)

    def console(self):
        """Without what is said of this test's own reading of the canvas."""
        return [entry["message"] for entry in self.browser.get_log("browser") if "willReadFrequently" not in entry["message"]]

    def test_turned_by_mouse_and_keys_and_back(self):
        before = self.seen()
        ActionChains(self.browser, duration=20).click_and_hold(self.canvas()).move_by_offset(90, 30).release().perform()
        self.changed(before)
        self.settle()
        turned = self.seen()
        self.assertNotEqual(turned, before)
        self.canvas().send_keys(Keys.ARROW_LEFT, Keys.ARROW_UP, "+")
        self.changed(turned)
        self.settle()
        self.canvas().send_keys("r")
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: self.seen() == before)
        self.assertEqual(self.console(), [])

    def test_a_method_its_parameters_and_the_objects_have_controls(self):
        plain = self.seen()
        Select(self.control("second method")).select_by_visible_text("fourier")
        self.settle("fourier", "RMSE", "SSIM")
        split = self.seen()
        self.assertNotEqual(split, plain)
        self.canvas().send_keys("5")
        self.changed(split)
        bands = self.browser.find_element(By.CSS_SELECTOR, '[aria-label^="bands"][aria-label$="of fourier"]')
        bands.send_keys(Keys.HOME)
        self.settle("bands=1")
        Select(self.control("second method")).select_by_visible_text("none")
        self.settle()
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: self.seen() == plain)
        self.control("opacity of objects[0]").send_keys(Keys.END)
        self.changed(plain)
        self.assertEqual(self.console(), [])

    def test_a_picture_whose_body_is_cut_short_is_asked_for_again(self):
        """A slider that moves aborts the picture that is on its way: its head may have come by then."""
        self.browser.execute_script("""
            const fetchIt = window.fetch;
            window.fetch = async (...words) => {
              const response = await fetchIt(...words);
              if (!window.wasCut && words[0] === "frame")
                response.arrayBuffer = () => { window.wasCut = true; return Promise.reject(new DOMException("", "AbortError")); };
              return response;
            };""")
        plain = self.seen()
        self.control("opacity of objects[0]").send_keys(Keys.END)
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: self.browser.execute_script("return window.wasCut"))
        self.changed(plain)
        self.settle("raytrace")
        self.assertEqual(self.console(), [])

    def test_sliders_reach_bounds_and_defaults(self):
        Select(self.control("second method")).select_by_visible_text("fourier")
        self.settle("fourier", "RMSE")
        slider = self.control("clamp of fourier")
        said = lambda: slider.get_attribute("aria-valuetext")
        self.assertEqual(said(), "0.9999")
        slider.send_keys(Keys.END)
        self.settle("clamp=0.999999")
        slider.send_keys(Keys.ARROW_LEFT)
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: said() == "0.9999" and "clamp" not in self.numbers())
        slider.send_keys(Keys.HOME)
        self.settle("clamp=0")
        reset = self.control("Reset clamp of fourier")
        reset.click()
        self.assertEqual(said(), "0.9999")
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: "clamp" not in self.numbers())
        self.assertFalse(reset.is_displayed())
        # Near 0 the stops of a small default are as fine as it is.
        Select(self.control("second method")).select_by_visible_text("raytrace")
        self.settle("raytrace", "RMSE")
        contrast = self.control("contrast of raytrace")
        self.assertEqual(contrast.get_attribute("aria-valuetext"), "0.01")
        contrast.send_keys(Keys.ARROW_LEFT)
        self.assertGreater(float(contrast.get_attribute("aria-valuetext")), 0.009)
        contrast.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(contrast.get_attribute("aria-valuetext"), "0.01")
        self.assertEqual(self.console(), [])

    def test_a_probe_is_that_of_render(self):
        Select(self.browser.find_element(By.CSS_SELECTOR, '[aria-label="Size of the pictures"]')).select_by_value("scene")
        self.settle("96 × 64")
        self.canvas().send_keys(Keys.SHIFT, Keys.ARROW_RIGHT, Keys.NULL, Keys.ENTER)
        WebDriverWait(self.browser, LONGEST, 0.02).until(
            lambda _: self.browser.find_element(By.ID, "probe").is_displayed())
        panel = self.browser.find_element(By.ID, "probe")
        title = panel.find_element(By.TAG_NAME, "h2").text
        x, y = (int(word) for word in title.removeprefix("Pixel ").split(", "))
        out = self.folder / "probe.json"
        subprocess.run([PROGRAM, "render", self.scene, "-m", "raytrace", "-o", self.folder / "a.png", "--quiet",
                        "--probe", f"{x},{y}", "--probe-out", out], check=True, stdout=subprocess.DEVNULL)
        pixel = json.loads(out.read_text())["pixels"][0]
        self.assertGreater(len(pixel["layers"]), 0)
        self.assertEqual(len(panel.find_elements(By.CSS_SELECTOR, "tbody tr")), len(pixel["layers"]))
        transmittance = float(panel.text.split("transmittance ")[1].split(".\n")[0])
        self.assertAlmostEqual(transmittance, pixel["transmittance"], delta=5e-7)
        cells = [cell.text for cell in panel.find_elements(By.CSS_SELECTOR, "tbody tr:first-child td")]
        self.assertAlmostEqual(float(cells[3]), pixel["layers"][0]["depth"], delta=1e-4)
        self.assertEqual(self.console(), [])

    def test_the_camera_is_saved_and_printed(self):
        text = self.scene.read_text()
        self.canvas().send_keys(Keys.ARROW_LEFT)
        self.settle()
        self.button("save camera").click()
        WebDriverWait(self.browser, LONGEST, 0.02).until(lambda _: self.scene.read_text() != text)
        saved = json.loads(self.scene.read_text())
        self.assertNotEqual(saved["camera"]["eye"], [0.3, 0.3, 3])
        self.assertEqual(saved["objects"], json.loads(text)["objects"])
        self.button("print camera").click()
        WebDriverWait(self.browser, LONGEST, 0.02).until(
            lambda _: "--camera eye=" in self.browser.find_element(By.CSS_SELECTOR, ".said").text)
        self.scene.write_text(text)

    def test_the_camera_is_added_to_the_study(self):
        for count in 1, 2:
            self.button("add to study").click()
            WebDriverWait(self.browser, LONGEST, 0.02).until(
                lambda _: f"view {count} of " in self.browser.find_element(By.CSS_SELECTOR, ".said").text)
        views = json.loads(self.study.read_text())["views"]
        self.assertEqual(len(views), 2)
        self.assertEqual(views[0]["fov"], 30)

    def test_everything_has_a_name(self):
        nameless = self.browser.execute_script("""return [...document.querySelectorAll(
            "button, input, select, canvas")].filter((e) => !(e.getAttribute("aria-label") || e.labels?.length ||
            e.textContent.trim())).map((e) => e.outerHTML)""")
        self.assertEqual(nameless, [])

    def test_nothing_is_wider_than_a_narrow_window(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        try:
            self.browser.get(self.server.address)
            self.settle()
            self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), 390)
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_strangers_are_refused(self):
        path = self.server.path
        self.assertEqual(self.server.get(path + "scene/0/")[0], 200)
        self.assertEqual(self.server.get("/")[0], 403)
        self.assertEqual(self.server.get("/" + "0" * 32 + "/scene/0/")[0], 403)
        self.assertEqual(self.server.get(path, Host="evil.example")[0], 403)
        self.assertEqual(self.server.get(path, Origin="http://evil.example")[0], 403)
        self.assertEqual(self.server.get(path + "scene/0/../../../../etc/passwd")[0], 404)
        self.assertEqual(self.server.get(path + "scene/0/%2e%2e/%2e%2e/etc/passwd")[0], 404)

    def test_a_torn_connection_harms_nobody(self):
        for sent in (b"", b"GET ", b"POST %sscene/0/frame HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nContent-Type: application/json\r\n"
                     b"Content-Length: 1000\r\n\r\n{" % (self.server.path.encode(), self.server.port)):
            connection = socket.create_connection(("127.0.0.1", self.server.port))
            connection.sendall(sent)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")  # a reset, at once
            connection.close()
        self.assertEqual(self.server.get(self.server.path + "scene/0/")[0], 200)

    def test_whoever_waits_takes_no_processor_time(self):
        time.sleep(2.5)  # connections are kept open for two seconds
        before = self.server.processor_seconds()
        time.sleep(1.5)
        self.assertLessEqual(self.server.processor_seconds() - before, 0.02)  # the clock ticks by hundredths


class FarTest(unittest.TestCase):
    def test_far_from_the_origin_a_camera_turns_as_near_to_it(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            scene = make_scene(folder)
            text = json.loads(scene.read_text())
            far = 1048576 + 0.3  # doubles have 2e-10 there
            text["camera"].update(eye=[far, far, 3], target=[far, far, 0])
            scene.write_text(json.dumps(text))
            server, browser = Server(scene), start_browser()
            try:
                browser.get(server.address)
                WebDriverWait(browser, 8, 0.02).until(lambda _: "16 samples" in browser.find_element(By.ID, "numbers").text)
                canvas = browser.find_element(By.ID, "canvas")
                canvas.send_keys(*[Keys.ARROW_LEFT] * 4)
                ActionChains(browser, duration=20).key_down(Keys.SHIFT).click_and_hold(canvas).move_by_offset(40, 0).release().key_up(Keys.SHIFT).perform()
                canvas.send_keys("+", "+")
                browser.find_element(By.XPATH, "//button[.='print camera']").click()
                said = WebDriverWait(browser, 8, 0.02).until(lambda _: browser.find_element(By.CSS_SELECTOR, ".said").text)
                eye, target = ([float(x) for x in said.split(f"{of}=")[1].split(",")[:3]] for of in ("eye", "target"))
                distance = math.dist(eye, target)
                # Eye and target are rounded to a millionth of the distance each, some times.
                self.assertAlmostEqual(distance, 3 / 1.1 ** 2, delta=3e-5)
                angle = math.degrees(math.atan2(eye[0] - target[0], eye[2] - target[2]))
                self.assertAlmostEqual(abs(angle), 20, delta=1e-3)
            finally:
                browser.quit()
                self.assertEqual(server.end(), 0)


class EndTest(unittest.TestCase):
    def test_it_ends_with_its_terminal(self):
        with tempfile.TemporaryDirectory() as name:
            scene = make_scene(pathlib.Path(name))
            self.assertEqual(Server(scene).end(), 0)
            for ending in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
                server = Server(scene)
                server.process.send_signal(ending)
                self.assertEqual(server.process.wait(10), 0, ending)
                server.end()


if __name__ == "__main__":
    unittest.main()
