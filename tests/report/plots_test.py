# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's plots: where labels stand, and what is saved of each."""

import csv
import io
import json
import unittest
import xml.dom.minidom

from report_page import ReportPage, By, WebDriverWait


class PlotsTest(ReportPage):
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

    def test_costs_over_sizes_have_exponents(self):
        self.browser.get(self.growth.as_uri())
        self.draw_all()
        section = self.browser.find_element(By.ID, "growth")
        self.assertEqual([h.text.split("\n")[0] for h in section.find_elements(By.CSS_SELECTOR, "h3")], ["Time over pixels", "Memory over pixels"])
        cells = {r.find_elements(By.TAG_NAME, "td")[0].text: [c.text for c in r.find_elements(By.TAG_NAME, "td")[1:]]
                 for r in section.find_elements(By.CSS_SELECTOR, "tbody tr")}
        self.assertEqual(set(cells), {"raytrace", "weighted-average", "linked-list"})
        # Its targets have a fixed number of bytes a pixel.
        self.assertEqual(cells["weighted-average"][1], "1.00 (1.00–1.00), last 1.00")
        for plot in section.find_elements(By.CSS_SELECTOR, ".plot"):
            self.assertTrue(plot.find_elements(By.CSS_SELECTOR, "svg .mark-line"), plot.text)

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


if __name__ == "__main__":
    unittest.main()
