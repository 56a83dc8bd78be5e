# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's viewer: what it shows and reads out, by mouse and by keys alone."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "export"))
import exr
from report_page import ReportPage, TITLE, ActionChains, By, Keys


class ViewerTest(ReportPage):
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

    def seen(self):
        """Of the stage's canvas a hash (FNV-1a, by pixels) and the number of colours."""
        return tuple(self.browser.execute_script("""const c = document.querySelector("dialog canvas");
            const pixels = new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer);
            let hash = 2166136261;
            for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 16777619);
            return [hash >>> 0, new Set(pixels).size]"""))


if __name__ == "__main__":
    unittest.main()
