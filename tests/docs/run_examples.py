#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples of a document, and holds it to the program: run_examples.py DOCUMENT.

A comment before a fenced block says what the block is:

    <!-- file: studies/bands.json -->   it is written to this path
    <!-- run -->                        sh runs its lines; `run: exit 2` expects that exit code
    <!-- run where: sinfo -h -->        sh runs its lines where that command succeeds; elsewhere they are left out, with a line
    <!-- output -->                     the last run printed each of its lines; … stands for any text
    <!-- with: studies/first.json -->   its keys, in place of that study's own, make a study that runs

All of a document's blocks share one temporary folder, in which `pellucid` is $PELLUCID_PROGRAM.
Scenes and studies are written at low cost. JSON without a mark has to parse.

The document of a file describes every key that the program accepts there, and every column of the
tables that it leaves: each stands as code in a heading or in the first cell of a table's row.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from known_names import names_of


class Failure(Exception):
    """What is wrong, and where."""


BLOCK = re.compile(r"(?:^<!-- *(?P<mark>.*?) *-->\n\n?)?^```(?P<language>\w*)\n(?P<text>.*?)^```$",
                   re.MULTILINE | re.DOTALL)


def blocks_of(document):
    """The line, mark (None without one), language and text of each fenced block."""
    for match in BLOCK.finditer(document):
        line = document.count("\n", 0, match.start("text")) + 1
        yield line, match["mark"], match["language"], match["text"]


def commands_of(text):
    """Its lines; one that ends in a backslash goes on."""
    return [line for line in text.replace("\\\n", " ").splitlines() if line.strip()]


def at_low_cost(text):
    """The scene or study of a JSON text, with one timed picture of each cell and half as many pixels along each side."""
    file = json.loads(text)
    if "repeats" in file:
        file["repeats"] = 1
    if "timing" in file:
        file["timing"] = {**file["timing"], "min": 5, "max": 5}
    if "resolution" in file:
        file["resolution"] = [side // 2 for side in file["resolution"]]
    for crop in file.get("crops", {}).values():
        crop[:] = [side // 2 for side in crop]
    for pixels in file.get("probes", {}).values():
        pixels[:] = [[column // 2, row // 2] for column, row in pixels]
    return file


def squeezed(text):
    return re.sub(r"\s+", " ", text).strip()


class Runner:
    """Runs the blocks of one document in `folder`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.printed = ""
        self.left_out = False  # the last run

    def take(self, mark, language, text):
        kind, _, argument = (mark or "").partition(": ")
        if kind == "file":
            self.write(argument, text)
        elif kind == "run":
            self.run(text, int(argument.removeprefix("exit ") or 0))
        elif kind == "run where":
            self.run_where(argument, text)
        elif kind == "with":
            self.run_study_with(argument, text)
        elif kind == "output":
            if not self.left_out:
                self.find_in_output(text)
        elif mark:
            raise Failure(f"unknown mark '{mark}'")
        if language == "json" and kind != "with":
            json.loads(text)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(at_low_cost(text)) if name.endswith(".json") else text)

    def run_where(self, condition, text):
        if subprocess.run(["sh", "-c", condition], cwd=self.folder, capture_output=True).returncode == 0:
            return self.run(text)
        self.left_out = True
        print(f"not run, since '{condition}' fails here: {commands_of(text)[0]} …")

    def run(self, text, expected=0):
        self.printed, self.left_out = "", False
        for command in commands_of(text):
            done = subprocess.run(["sh", "-c", command], cwd=self.folder, capture_output=True, text=True)
            self.printed += done.stdout + done.stderr
            if done.returncode != expected:
                raise Failure(f"{command}\nexit code {done.returncode}, not {expected}\n{done.stderr}")

    def run_study_with(self, base, text):
        study = {**json.loads((self.folder / base).read_text()), **at_low_cost("{" + text + "}")}
        name = Path(base).with_name("with.json")
        (self.folder / name).write_text(json.dumps(study))
        self.run(f"pellucid study {name} -o with")

    def find_in_output(self, text):
        printed = squeezed(self.printed)
        for line in filter(None, map(squeezed, text.splitlines())):
            pattern = ".*".join(re.escape(part) for part in line.split("…"))
            if not re.search(pattern, printed):
                raise Failure(f"the command did not print '{line}', but\n{self.printed}")


def described_names(document):
    """The words that stand as code in a heading or in the first cell of a table's row."""
    prose = BLOCK.sub("", document)
    places = re.findall(r"^#+ .*|^\|[^|]*\|", prose, re.MULTILINE)
    code = re.findall(r"`([^`]*)`", " ".join(places))
    return set(re.findall(r"[\w-]+", " ".join(code)))


def check_document(path):
    document = path.read_text()
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(folder)
        for line, mark, language, text in blocks_of(document):
            try:
                runner.take(mark, language, text)
            except (Failure, ValueError, OSError) as error:
                raise Failure(f"{path}:{line}: {error}") from error
        names = names_of(path.name, Path(folder))
    missing = sorted(names - described_names(document))
    if missing:
        raise Failure(f"{path}: the program knows {', '.join(missing)}; the document does not")


def put_program_on_path(folder):
    program = Path(os.environ.get("PELLUCID_PROGRAM", "build/release/pellucid"))
    (Path(folder) / "pellucid").symlink_to(program.resolve())
    if "PELLUCID_PYTHON" in os.environ:  # the one that the module is for
        (Path(folder) / "python3").symlink_to(os.environ["PELLUCID_PYTHON"])
    os.environ["PATH"] = f"{folder}:{os.environ['PATH']}"


def main():
    with tempfile.TemporaryDirectory() as folder:
        put_program_on_path(folder)
        try:
            check_document(Path(sys.argv[1]))
        except Failure as failure:
            sys.exit(str(failure))


if __name__ == "__main__":
    main()
