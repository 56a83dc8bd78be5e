#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each kind of wrong row of docs/papers.md, in a tree of a few files, is found by check_papers.py."""

import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import check_papers

PAPERS = {"F": {"Eq.": 2, "Fig.": 1}}
PAGE = """# Papers

| what | study | source file | verdict | why |
|---|---|---|---|---|
| F Eq. 1, energy | — | `scene/energy.h` | erratum | q and r stand by the other's sum |
| F Eq. 2, opacity | — | — | missing | a definition |
| F Sect. 4.2, its third step | — | `scene/energy.h` | other | on the CPU |
| F Fig. 1, blending | `blending` | — | other | 400² in place of 1000² |
| F Fig. 1: “All are faster.” | `blending` | — | claim | “Others are faster.” |
| F Fig. 1: “It looks alike.” | — | — | no claim yet | |
"""
STUDY = {"source": "Baeza Rojo et al. 2019, Fig. 1", "claims": [{"claim": "Others are faster."}]}


def write(folder, page, studies):
    for name, text in {"docs/papers.md": page, "scene/energy.h": "// Eq. 1: energy\n",
                       **{f"studies/{name}.json": json.dumps(study) for name, study in studies.items()}}.items():
        path = Path(folder) / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)


def found(page, studies):
    with tempfile.TemporaryDirectory() as folder, mock.patch.object(check_papers, "PAPERS", PAPERS):
        write(folder, page, studies)
        return list(check_papers.errors(Path(folder)))


class WrongRows(unittest.TestCase):
    def finds(self, before, after, words, studies={"blending": STUDY}):
        """One error, which has these words, once the page's text `before` is changed."""
        self.assertIn(before, PAGE)
        errors = found(PAGE.replace(before, after, 1), studies)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(words, errors[0])

    def test_a_page_in_order_has_none(self):
        self.assertEqual(found(PAGE, {"blending": STUDY}), [])

    def test_study_that_is_not_there(self):
        self.finds("Fig. 1, blending | `blending`", "Fig. 1, blending | `blend`",
                   "papers.md:8: F Fig. 1: studies/blend.json is not there")

    def test_file_that_is_not_there(self):
        self.finds("4.2, its third step | — | `scene/energy.h`", "4.2, its third step | — | `scene/power.h`",
                   "scene/power.h is not there")

    def test_file_without_the_equation(self):
        self.finds("Eq. 2, opacity | — | — | missing", "Eq. 2, opacity | — | `scene/energy.h` | same",
                   "scene/energy.h does not name it")

    def test_study_that_cites_a_paper_without_a_row(self):
        self.finds("Papers", "Papers", "no row names the study bins", {"blending": STUDY, "bins": STUDY})

    def test_study_of_no_paper_needs_no_row(self):
        self.assertEqual(found(PAGE, {"blending": STUDY, "quickstart": {"claims": STUDY["claims"]}}), [])

    def test_study_without_claims(self):
        self.finds("Papers", "Papers", "studies/quickstart.json: claims nothing",
                   {"blending": STUDY, "quickstart": {"claims": []}})

    def test_number_without_a_row(self):
        self.finds("| F Eq. 2, opacity | — | — | missing | a definition |\n", "", "F Eq. 2 has 0 rows")

    def test_number_with_two_rows(self):
        self.finds("F Sect. 4.2,", "F Eq. 1,", "F Eq. 1 has 2 rows")

    def test_number_that_the_paper_does_not_have(self):
        self.finds("F Sect. 4.2,", "F Table 3,", "the papers have no F Table 3")

    def test_verdict_of_no_kind(self):
        self.finds("| other | on the CPU", "| nearly | on the CPU", "verdict 'nearly'")

    def test_verdict_of_an_item_for_a_sentence(self):
        self.finds("| no claim yet |", "| same |", "verdict 'same'")

    def test_no_reason(self):
        self.finds("| on the CPU |", "| |", "does not say why")

    def test_nothing_that_would_be_the_same(self):
        self.finds("| missing | a definition", "| same | a definition", "names neither")

    def test_claim_of_no_study(self):
        self.finds("“Others are faster.”", "“Others are slower.”",
                   "no study of the row claims “Others are slower.”")

    def test_claim_without_its_words(self):
        self.finds("“Others are faster.”", "as there", "quotes no claim")

    def test_sentence_below_another_item(self):
        self.finds("F Fig. 1: “It looks alike.”", "F Eq. 1: “It looks alike.”", "a sentence stands below its item")

    def test_line_that_is_no_row(self):
        self.finds("F Sect. 4.2,", "F Section 4.2,", "is no item of a paper")

    def test_row_of_too_few_cells(self):
        self.finds("| other | on the CPU |", "| other |", "papers.md:7: 4 cells, not 5")

    def test_study_that_is_not_code(self):
        self.finds("4.2, its third step | —", "4.2, its third step | blending", "stand as code")


if __name__ == "__main__":
    unittest.main()
