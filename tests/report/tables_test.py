# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's tables and what it says of costs that are not known, of ties, of views, and of where numbers come from."""

import csv
import datetime
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "export"))
import exr
from report_page import ReportPage, By, Keys, WebDriverWait


class TablesTest(ReportPage):
    def test_what_is_not_known_of_a_given_picture_is_not_0(self):
        self.console()  # what others have left
        self.browser.get(self.given.as_uri())
        self.assertEqual(self.console(), [])
        row = self.browser.find_element(By.XPATH, "//section[@id='table']//tr[td[starts-with(., 'theirs')]]").text
        self.assertIn("–", row)
        self.assertNotIn("0.0", row.split())
        choices = [row.text for row in self.browser.find_elements(By.CSS_SELECTOR, "#choices tbody tr")]
        answers = [re.sub("^.*?≤ [0-9.]+( … [0-9.]+)?", "", choice) for choice in choices]
        self.assertEqual(len({*answers}), len(answers))  # neighbouring bounds of one answer are one row
        bounds = re.findall("[0-9.]+", " ".join(re.search("≤ [0-9.]+( … [0-9.]+)?", choice)[0] for choice in choices))
        self.assertEqual((bounds[0], bounds[-1]), ("0.1", "0.0001"))
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

    def test_small_pictures_of_all_views_frame_the_worst(self):
        self.browser.get(self.views.as_uri())
        rows = {row["method"]: row for row in json.loads((self.views.parent / "results.json").read_text())["rows"]}
        lines = self.browser.find_elements(By.CSS_SELECTOR, ".views tr")
        self.assertEqual(len(lines), 3)
        for line in lines:
            self.browser.execute_script("arguments[0].scrollIntoView()", line)
            cells = line.find_elements(By.TAG_NAME, "td")
            WebDriverWait(self.browser, 5, 0.02).until(lambda _: all(
                self.browser.execute_script("return arguments[0].naturalWidth", image) > 0 for image in line.find_elements(By.TAG_NAME, "img")))
            self.assertEqual(len(cells), 3)
            worst = [i for i, cell in enumerate(cells) if "worst" in cell.get_attribute("class")]
            row = rows[line.find_element(By.TAG_NAME, "th").text.split("\n")[0]]
            errors = next((curve["y"] for curve in row["curves"] if curve["name"] == "RMSE over the views"), [])
            apart = not row["reference"] and len(set(errors)) > 1
            self.assertEqual(worst, [errors.index(max(errors))] if apart else [])
        self.assertGreater(len(set(next(c["y"] for c in rows["weighted-average"]["curves"] if c["name"] == "RMSE over the views"))), 1)

    def test_with_views_it_says_of_which_pictures_and_numbers_are(self):
        self.browser.get(self.views.as_uri())
        self.assertIn("are of view 1 of 3; numbers are means over the views", self.browser.find_element(By.CSS_SELECTOR, "section .lead").text)
        captions = [c.text for c in self.browser.find_elements(By.CSS_SELECTOR, "figcaption header")]
        self.assertTrue(all("view 1 of 3" in caption for caption in captions), captions)
        self.browser.find_elements(By.CSS_SELECTOR, ".enlarge")[1].send_keys(Keys.ENTER)
        self.wait_for("sheets · weighted-average · view 1 of 3")
        self.assertIn("means over 3 views: ", self.browser.find_element(By.CSS_SELECTOR, "dialog .heading span").text)
        self.assertIn("Of view 1 of 3.", self.saved("Error over the number of layers, view 1", "SVG"))
        self.assertIn("means over 3 views", (self.views.parent / "table.md").read_text())
        figure = self.folder / "views.tex"
        subprocess.run([os.environ["PELLUCID_PROGRAM"], "figure", self.views.parent, "-o", figure], check=True, stdout=subprocess.DEVNULL)
        self.assertIn("Pictures are of view 1 of 3, numbers means over the views.", figure.read_text())

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


if __name__ == "__main__":
    unittest.main()
