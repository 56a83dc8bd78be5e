# SPDX-License-Identifier: GPL-3.0-or-later
"""A report on paper: nothing is cut off."""

import base64
import re
import subprocess
import unittest

from report_page import ReportPage, By


class PaperTest(ReportPage):
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


if __name__ == "__main__":
    unittest.main()
