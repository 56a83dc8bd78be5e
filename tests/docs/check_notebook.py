#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the cells of an executed notebook again, and fails where one prints or shows something else than it holds:
check_notebook.py NOTEBOOK; with --update after it the notebook then holds what they print and show. Jupyter need
not be installed."""

import ast
import base64
import contextlib
import io
import json
import sys
from pathlib import Path


def run_cell(source, names):
    """What it prints, and the value of its last line, if that is an expression."""
    body = ast.parse(source).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None
    return printed.getvalue(), value


def text_of(lines):
    return lines if isinstance(lines, str) else "".join(lines)


def complaints(cell, names):
    printed, value = run_cell(text_of(cell["source"]), names)
    held = "".join(text_of(o["text"]) for o in cell["outputs"] if o["output_type"] == "stream")
    if printed != held:
        yield f"prints\n{printed}but holds\n{held}"
    pictures = [o["data"]["image/png"] for o in cell["outputs"] if "image/png" in o.get("data", {})]
    if hasattr(value, "_repr_png_") != bool(pictures):
        yield "a picture is shown and not held, or held and not shown"
    for picture in pictures:
        if base64.b64decode(text_of(picture)) != value._repr_png_():
            yield "the picture is another one"


def update(cell, names):
    """Takes what the cell prints and shows in the place of what it holds."""
    printed, value = run_cell(text_of(cell["source"]), names)
    streams = [output for output in cell["outputs"] if output["output_type"] == "stream"]
    cell["outputs"] = streams[:1] + [output for output in cell["outputs"] if output not in streams]
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            output["text"] = printed.splitlines(keepends=True)
        elif "image/png" in output.get("data", {}):
            output["data"]["image/png"] = base64.b64encode(value._repr_png_()).decode()


def update_all(path):
    notebook, names = json.loads(path.read_text()), {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            update(cell, names)
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")


def main():
    if sys.argv[2:] == ["--update"]:
        return update_all(Path(sys.argv[1]))
    notebook = json.loads(Path(sys.argv[1]).read_text())
    names, wrong, cells = {}, 0, 0
    for number, cell in enumerate(notebook["cells"]):
        if cell["cell_type"] != "code":
            continue
        cells += 1
        if not cell["execution_count"]:
            sys.exit(f"cell {number} was not executed")
        for complaint in complaints(cell, names):
            print(f"cell {number}: {complaint}", file=sys.stderr)
            wrong += 1
    return 1 if wrong or cells < 3 else 0


if __name__ == "__main__":
    sys.exit(main())
