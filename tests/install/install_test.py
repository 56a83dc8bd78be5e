# SPDX-License-Identifier: GPL-3.0-or-later
"""What cmake --install leaves works as a whole, wherever it is moved, in a folder without the sources."""

import os
import re
import shutil
import subprocess

import pytest
from conftest import BUILD, run

SCENE = """{"format": "pellucid-scene", "version": 1, "resolution": [32, 32],
            "objects": [{"dataset": "stack:layers=3"}]}"""


def commands_of(prefix):
    """Those of --help, whose headings CLI11 writes in capitals from 2.5 on."""
    text = run(prefix / "bin/pellucid", "--help")
    return re.findall(r"^  (\w+)  ", re.split("^subcommands:", text, flags=re.MULTILINE | re.IGNORECASE)[1], re.MULTILINE)


def test_studies_and_helpers_are_found(prefix, tmp_path):
    program = prefix / "bin/pellucid"
    assert "quickstart" in run(program, "list", "studies", cwd=tmp_path)
    (tmp_path / "scene.json").write_text(SCENE)
    for name in "a.png", "b.png":
        run(program, "render", "scene.json", "-m", "raytrace", "-o", name, "--quiet", cwd=tmp_path)
    assert "RMSE" in run(program, "compare", "a.png", "b.png", cwd=tmp_path)


def test_a_method_on_opengl_has_its_shaders(prefix, tmp_path):
    (tmp_path / "scene.json").write_text(SCENE)
    run(prefix / "bin/pellucid", "render", "scene.json", "-m", "fourier", "-o", "a.png", cwd=tmp_path)


def test_the_module_is_found_with_its_helpers(prefix, tmp_path):
    code = ("import pellucid, numpy as np; p = pellucid.load_scene('scene.json').render(); p.save('a.png');"
            "print(pellucid.__file__, pellucid.compare('a.png', 'a.png')['rmse']);"
            "import pytest; pytest.raises(pellucid.InputError, pellucid.run_study, 'quickstart', 'o', only='no/fit')")
    (tmp_path / "scene.json").write_text(SCENE)
    path = prefix / "lib/python3/dist-packages"
    printed = run(os.environ["PELLUCID_PYTHON"], "-c", code, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(path)})
    assert printed.strip() == f"{path}/pellucid/__init__.py 0.0"


def test_nothing_knows_where_it_was_built(prefix):
    """The program and its helpers hold no path of the sources or of the build."""
    for file in [prefix / "bin/pellucid", *sorted((prefix / "libexec/pellucid").iterdir())]:
        assert os.fsencode(BUILD) not in file.read_bytes(), file


def test_every_command_has_a_manual_page_without_a_complaint(prefix):
    commands = commands_of(prefix)
    assert len(commands) >= 9
    pages = {page.name for page in (prefix / "share/man/man1").iterdir()}
    assert pages == {"pellucid.1"} | {f"pellucid-{c}.1" for c in commands}
    files = [prefix / "share/man/man1" / name for name in sorted(pages)]
    done = subprocess.run(["man", "--warnings=w", "-E", "UTF-8", "-l", *files], capture_output=True, text=True,
                          env={**os.environ, "MANWIDTH": "100"})
    assert done.returncode == 0 and not done.stderr, done.stderr


def test_a_manual_page_says_what_help_says(prefix):
    page = run("man", "-E", "ASCII", "-l", prefix / "share/man/man1/pellucid-render.1", env={**os.environ, "MANWIDTH": "300"})
    text = run(prefix / "bin/pellucid", "render", "--help")
    options = set(re.findall(r"--[a-z][a-z-]*", text))
    assert len(options) > 8 and options <= set(re.findall(r"--[a-z][a-z-]*", page.replace("\n", " ")))


def complete(prefix, *words):
    """What bash offers for the last of the words."""
    script = (f"source {prefix}/share/bash-completion/completions/pellucid; COMP_WORDS=(\"$@\"); "
              "COMP_CWORD=$(($# - 1)); _pellucid; printf '%s\\n' \"${COMPREPLY[@]}\"")
    return run("bash", "-c", script, "bash", "pellucid", *words).split()


def test_bash_completes_commands_options_and_names(prefix):
    assert complete(prefix, "ren") == ["render"]
    assert set(commands_of(prefix)) <= set(complete(prefix, ""))
    assert "--method" in complete(prefix, "render", "scene.json", "--me")
    assert complete(prefix, "render", "scene.json", "-m", "fourier") == ["fourier", "fourier-opacity"]
    assert "quickstart" in complete(prefix, "study", "qu")
    assert complete(prefix, "list", "colorm") == ["colormaps"]
    assert complete(prefix, "render", "scene") == []  # bash then offers files


@pytest.mark.skipif(not shutil.which("zsh"), reason="zsh is not installed")
def test_zsh_completes_the_same(prefix):
    """With functions in the place of the shell's own, which print what they are given."""
    script = ("compdef() { }; compadd() { shift; print -l -- $@ }; _files() { print FILES }; "
              f"source {prefix}/share/zsh/vendor-completions/_pellucid; words=(pellucid \"$@\"); CURRENT=$#words; _pellucid")

    def offered(*words):
        return set(run("zsh", "-fc", script, "zsh", *words).split())

    assert set(commands_of(prefix)) <= offered("")
    assert {"fourier", "raytrace", "FILES"} <= offered("render", "scene.json", "-m", "")
    assert "quickstart" in offered("study", "")
    assert "--method" in offered("render", "scene.json", "--") and "FILES" not in offered("render", "--")
    assert offered("render", "scene.json", "") == {"FILES"}


def test_wrong_pages_and_shells_are_refused(prefix):
    for words, expected in (("--manual", "rendr"), "render"), (("--completion", "fish"), "bash"):
        done = subprocess.run([prefix / "bin/pellucid", *words], capture_output=True, text=True)
        assert done.returncode == 2 and expected in done.stderr and done.stderr.count("\n") == 1
