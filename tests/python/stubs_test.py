# SPDX-License-Identifier: GPL-3.0-or-later
"""The type stubs name all that the module has, with its parameters and defaults, and nothing else."""

import ast
import re
from pathlib import Path

import pellucid

STUBS = ast.parse((Path(pellucid.__file__).parent / "__init__.pyi").read_text())
NO_STUBS = {"__repr__", "__init__", "__module__", "__doc__", "__new__", "__weakref__", "__dict__"}


def stubbed(body):
    """The public definitions of a class or of the module by name."""
    found = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
    return found


def parameters_of(function):
    """[(name, keyword only?, default)] of a stub's function, without self."""
    a = function.args
    defaults = [None] * (len(a.args) - len(a.defaults)) + a.defaults
    plain = [(p.arg, False, d and ast.literal_eval(d)) for p, d in zip(a.args, defaults)]
    keywords = [(p.arg, True, d and ast.literal_eval(d)) for p, d in zip(a.kwonlyargs, a.kw_defaults)]
    return [p for p in plain + keywords if p[0] != "self"] + ([("**", True, None)] if a.kwarg else [])


def parameters_in(doc):
    """The same of the signature that a compiled function's text begins with."""
    inside = re.match(r"\w+\((.*)\) ->", doc.splitlines()[0]).group(1)
    found, keyword = [], False
    for part in filter(None, re.split(r", (?![^\[(]*[\])])", inside)):
        if part == "*":
            keyword = True
        elif part.startswith("**"):
            found.append(("**", True, None))
        elif not part.startswith("self"):
            name, default = re.match(r"(\w+)[^=]*(?:= (.*))?$", part).groups()
            found.append((name, keyword, ast.literal_eval(default) if default else None))
    return found


def public(names):
    return {n for n in names if not n.startswith("_")}


def test_every_name_has_a_stub_and_every_stub_a_name():
    assert public(stubbed(STUBS.body)) == public(pellucid.__all__)
    assert "__version__" in stubbed(STUBS.body)


def test_every_member_has_a_stub_and_every_stub_a_member():
    for name, node in stubbed(STUBS.body).items():
        if not isinstance(node, ast.ClassDef) or issubclass(getattr(pellucid, name), Exception):
            continue
        kind = getattr(pellucid, name)
        there = {m for m in vars(kind) if m not in NO_STUBS and not m.startswith("_pybind11")}
        assert there == set(stubbed(node.body)) - {"__init__"}, name


def test_parameters_and_defaults_are_the_modules():
    compared = 0
    for name, node in stubbed(STUBS.body).items():
        thing = getattr(pellucid, name)
        members = stubbed(node.body).items() if isinstance(node, ast.ClassDef) else [(None, node)]
        for member, function in members:
            is_property = isinstance(function, ast.FunctionDef) and function.decorator_list
            if not isinstance(function, ast.FunctionDef) or is_property:
                continue
            doc = (getattr(thing, member) if member else thing).__doc__
            assert parameters_of(function) == parameters_in(doc), (name, member)
            compared += 1
    assert compared > 15


def test_everything_says_what_it_is():
    for name in public(pellucid.__all__):
        thing = getattr(pellucid, name)
        assert len(thing.__doc__) > 20, name
        for member in public(vars(thing)) if isinstance(thing, type) else []:
            doc = getattr(thing, member).__doc__ or ""
            assert re.sub(r"^\w+\(.*\n*", "", doc).strip(), (name, member)
