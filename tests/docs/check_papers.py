#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when docs/papers.md leaves out a number of the papers or names what is not there, and for a study without
claims: check_papers.py ROOT.

A row is | what | study | source file | verdict | why |. It is an item of a paper, `F Eq. 15, what it is`, with one of
VERDICTS; or, below a row of that item, a sentence of the paper about it, `F Fig. 7: “sentence”`: as a `claim`, with the
study's own words in “…” as the last cell, or `no claim yet`.
"""

import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path

from check_equations import numbers

# How many of each kind the papers have, numbered from 1.
PAPERS = {
    "F": {"Eq.": 19, "Fig.": 12, "Table": 1},
    "FA": {"Eq.": 5, "Theorem": 1, "Fig.": 6},
    "P": {"Algorithm": 2, "Fig.": 8},
    "I": {"Eq.": 3, "Fig.": 16},
}
# What a study's `source` says when it cites one of them.
CITED = re.compile(r"Baeza Rojo|Tian and Günther|Li, Chen")

VERDICTS = {"same", "other", "missing", "erratum"}
CLAIMED, UNCLAIMED = "claim", "no claim yet"
NONE = "—"

ITEM = re.compile(r"(?P<paper>\w+) (?P<kind>Eq\.|Fig\.|Table|Algorithm|Theorem|Sect\.) (?P<number>\d+(?:\.\d+)*)"
                  r"(?P<rest>, .+|: “.+”)")


@dataclass
class Row:
    line: int
    paper: str
    kind: str
    number: str
    is_sentence: bool
    studies: list
    files: list
    verdict: str
    why: str

    @property
    def item(self):
        return f"{self.paper} {self.kind} {self.number}"


def names(cell):
    """What stands as code in a cell."""
    return re.findall(r"`([^`]+)`", cell)


def is_list(cell):
    """A dash, or code alone."""
    return cell == NONE or re.fullmatch(r"`[^`]+`(, `[^`]+`)*", cell)


def read_row(line, text):
    """The row of a line of the table; what is wrong with it, as text, where it is none."""
    cells = [cell.strip() for cell in text.strip().strip("|").split("|")]
    if len(cells) != 5:
        return f"{len(cells)} cells, not 5"
    what, study, file, verdict, why = cells
    match = ITEM.fullmatch(what)
    if not match:
        return f"'{what}' is no item of a paper"
    if not is_list(study) or not is_list(file):
        return f"'{what}': its studies and files stand as code, or are {NONE}"
    return Row(line, match["paper"], match["kind"], match["number"], match["rest"].startswith(":"),
               names(study), names(file), verdict, why)


def rows_of(page):
    """The rows, and what is wrong with lines that are none."""
    rows, wrong = [], []
    for line, text in enumerate(page.splitlines(), 1):
        if not re.match(r"\| (?!what \|)", text):
            continue
        row = read_row(line, text)
        if isinstance(row, Row):
            rows.append(row)
        else:
            wrong.append(f"docs/papers.md:{line}: {row}")
    return rows, wrong


def read_studies(root):
    return {path.stem: json.loads(path.read_text()) for path in sorted((root / "studies").glob("*.json"))}


def claims_of(study):
    return {claim["claim"] for claim in study.get("claims", [])}


def wrong_sentence(row, studies, above):
    if row.verdict not in (CLAIMED, UNCLAIMED):
        yield f"verdict '{row.verdict}'; of a sentence: {CLAIMED}, {UNCLAIMED}"
    if not above or above.item != row.item:
        yield "a sentence stands below its item"
    if row.verdict != CLAIMED:
        return
    claims = set().union(*(claims_of(studies[name]) for name in row.studies if name in studies))
    quoted = re.findall("“([^”]+)”", row.why)
    if not quoted:
        yield "quotes no claim of its study"
    for claim in quoted:
        if claim not in claims:
            yield f"no study of the row claims “{claim}”"


def wrong_item(row, root):
    if row.verdict not in VERDICTS:
        yield f"verdict '{row.verdict}'; of an item: {', '.join(sorted(VERDICTS))}"
    if not row.why:
        yield "does not say why"
    if row.verdict in ("same", "other") and not (row.files or row.studies):
        yield f"'{row.verdict}', and names neither a study nor a file"
    if row.kind in ("Eq.", "Algorithm"):
        for file in row.files:
            if (root / file).is_file() and row.number not in numbers((root / file).read_text(), row.kind):
                yield f"{file} does not name it"


def wrong_names(row, studies, root):
    yield from (f"studies/{name}.json is not there" for name in row.studies if name not in studies)
    yield from (f"{file} is not there" for file in row.files if not (root / file).is_file())


def wrong_numbers(rows):
    """Of the papers' items those that have no row, or several; and rows of items that the papers do not have."""
    found = [row.item for row in rows if not row.is_sentence and row.kind != "Sect."]
    known = [f"{paper} {kind} {number}" for paper, kinds in PAPERS.items()
             for kind, count in kinds.items() for number in range(1, count + 1)]
    for item in known:
        if found.count(item) != 1:
            yield f"docs/papers.md: {item} has {found.count(item)} rows, not 1"
    yield from (f"docs/papers.md: the papers have no {item}" for item in sorted(set(found) - set(known)))


def errors(root):
    rows, wrong = rows_of((root / "docs/papers.md").read_text())
    yield from wrong
    studies = read_studies(root)
    above = None
    for row in rows:
        found = list(wrong_names(row, studies, root))
        found += wrong_sentence(row, studies, above) if row.is_sentence else wrong_item(row, root)
        yield from (f"docs/papers.md:{row.line}: {row.item}: {error}" for error in found)
        above = above if row.is_sentence else row
    yield from wrong_numbers(rows)
    named = {name for row in rows for name in row.studies}
    for name, study in studies.items():
        if CITED.search(study.get("source", "")) and name not in named:
            yield f"docs/papers.md: no row names the study {name}, which cites a paper"
        if not claims_of(study):
            yield f"studies/{name}.json: claims nothing, so that its results are held to nothing"


def main():
    found = list(errors(Path(sys.argv[1])))
    for error in found:
        print(error, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
