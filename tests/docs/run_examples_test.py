#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each kind of wrong example, in a document of a few lines, is found by run_examples.py."""

import contextlib
import io
import os
import tempfile
import unittest
from pathlib import Path

from run_examples import Failure, check_document, described_names, put_program_on_path

# In place of the program: it knows one key of a file, and says what it was told.
PROGRAM = """#!/bin/sh
grep -q '"title"' "$2" || { echo "$2: unknown key" >&2; exit 2; }
echo "$@ took 12 ms"
"""

DOCUMENT = """# A document

<!-- file: studies/first.json -->
```json
{ "title": "first", "repeats": 5 }
```

<!-- run -->
```sh
grep '"repeats": 1}' studies/first.json
pellucid study studies/first.json \\
  -o first
```

<!-- output -->
```text
study studies/first.json … took … ms
```

<!-- with: studies/first.json -->
```json
"repeats": 7
```

```json
{ "unmarked": 1 }
```
"""


def failure(before="", after=""):
    """What is found in the document once its text `before` is changed; None if nothing is."""
    assert before in DOCUMENT
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        os.environ["PELLUCID_PROGRAM"] = str(program)
        put_program_on_path(folder)
        path = Path(folder) / "document.md"
        path.write_text(DOCUMENT.replace(before, after, 1))
        try:
            return check_document(path)
        except Failure as found:
            return str(found)


class WrongExamples(unittest.TestCase):
    def finds(self, before, after, *words):
        found = failure(before, after)
        self.assertIsNotNone(found)
        for word in words:
            self.assertIn(word, found)

    def test_a_document_in_order_has_none(self):
        self.assertIsNone(failure())

    def test_misspelt_key(self):
        self.finds('"title"', '"tilte"', "document.md:10", "pellucid study studies/first.json", "exit code 2, not 0",
                   "unknown key")

    def test_wrong_exit_code(self):
        self.finds("<!-- run -->", "<!-- run: exit 1 -->", "exit code 0, not 1")

    def test_output_that_is_not_printed(self):
        self.finds("took … ms", "took … s", "did not print")

    def test_unmarked_json_that_does_not_parse(self):
        self.finds('"unmarked": 1', '"unmarked": ', "document.md:26")

    def test_unknown_mark(self):
        self.finds("<!-- run -->", "<!-- rnu -->", "unknown mark 'rnu'")

    def test_what_cannot_run_here_is_left_out_with_what_it_prints(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertIsNone(failure("<!-- run -->\n```sh\ngrep", "<!-- run where: false -->\n```sh\nexit 1; grep"))
        self.assertIn("not run, since 'false' fails here: exit 1; grep", said.getvalue())
        self.finds("<!-- run -->\n```sh\ngrep", "<!-- run where: true -->\n```sh\nexit 1; grep", "exit code 1, not 0")

    def test_keys_of_no_study(self):
        self.finds("with: studies/first.json", "with: studies/second.json", "second.json")


class Descriptions(unittest.TestCase):
    def test_headings_and_first_cells_describe(self):
        document = "## `title`, source\n| `camera.eye`, `up` | `fov` |\n```text\n| `fenced` |\n```\n`prose`\n"
        self.assertEqual(described_names(document), {"title", "camera", "eye", "up"})


if __name__ == "__main__":
    unittest.main()
