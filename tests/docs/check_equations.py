#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when docs/developing.md names a file that does not have the equation: check_equations.py ROOT.

A row is | paper | equation | what | `file` |. The file has "Eq. 15", or a list that holds it, such
as "Eqs. 14 to 19" or "Eqs. 1, 2, 10".
"""

import re
import sys
from pathlib import Path

ROW = re.compile(r"^\| (\w) \| (Eq\.|Algorithm|[Ss]ection|Sect\.) ([\d.]+) \| .* \| `([^`]+)` \|$", re.M)
LIST = r"(?:,? and |, | to |–)"


def numbers(text, kind):
    """All numbers that stand after `kind`, in the singular or the plural."""
    word = {"Eq.": r"Eqs?\.", "Algorithm": "Algorithms?", "Sect.": r"Sect\."}.get(kind, "[Ss]ections?")
    found = set()
    for match in re.finditer(rf"{word}\s+(\d[\d.]*(?:{LIST}\d[\d.]*)*)", re.sub(r"\n\s*(//+)?", " ", text)):
        parts = re.split(f"({LIST})", match.group(1))
        found.update(p.rstrip(".") for p in parts[::2])
        for low, join, high in zip(parts[::2], parts[1::2], parts[2::2]):
            if join.strip() in ("to", "–"):
                found.update(str(n) for n in range(int(low), int(high) + 1))
    return found


def errors(root):
    page = (root / "docs/developing.md").read_text()
    rows = ROW.findall(page)
    if len(rows) < 20:
        yield f"docs/developing.md: only {len(rows)} rows of equations found"
    for paper, kind, number, file in rows:
        path = root / file
        if not path.is_file():
            yield f"docs/developing.md: {paper} {kind} {number}: {file} is not there"
        elif number not in numbers(path.read_text(), kind):
            yield f"docs/developing.md: {paper} {kind} {number}: {file} does not name it"


def main():
    found = list(errors(Path(sys.argv[1])))
    for error in found:
        print(error, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
