#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails for an arrow that runs back up: check_rooms.py ROOT.

The order of the rooms, and of what lies in each, stands in the rooms' CMakeLists.txt:

    pellucid_room(NAME ORDER ENTRY… ROOMS ROOM… …)

ORDER names a room's sub-rooms, and the files at its top by their stems, in the order in which data
passes: what belongs to an entry includes only that entry and those before it. Folders inside a
sub-room have no order, but no circle either. ROOMS are the rooms to its left that it includes,
no more and no fewer. Arrows are C++ includes, GLSL includes, and the names of embedded shaders.
"""

import re
import sys
from pathlib import Path

CODE = {".h", ".cpp", ".inl", ".inc", ".glsl"}
MOST_FILES = 40  # of code in one folder


def identifier(name):
    """An embedded file's function, as cmake/embed.cmake makes it."""
    return re.sub(r"[^A-Za-z0-9]", "_", name)


def declared(text, keyword):
    """The words after `keyword` up to the next one in capitals or the end of the call."""
    call = re.search(r"pellucid_room\(([^)]*)\)", text)
    words = re.sub(r"#.*", "", call.group(1)).split() if call else []
    found, inside = [], False
    for word in words:
        if word in ("ORDER", "ROOMS", "LIBRARIES"):
            inside = word == keyword
        elif inside:
            found.append(word)
    return found


def is_ordered(text):
    return "pellucid_room(" in text


def declared_rooms(text):
    """Of a room, its ROOMS; of the program, the rooms that it is linked to."""
    if is_ordered(text):
        return set(declared(text, "ROOMS"))
    return set(re.findall(r"\bpellucid_(\w+)", text))


class Tree:
    """The code files below `root`, and the arrows between them."""

    def __init__(self, root):
        self.root = Path(root)
        text = (self.root / "CMakeLists.txt").read_text()
        self.rooms = re.search(r"foreach\(room ([^)]*)\)", text).group(1).split()
        self.cmake = {room: (self.root / room / "CMakeLists.txt").read_text() for room in self.rooms}
        self.files = [
            path.relative_to(self.root).as_posix()
            for room in self.rooms
            for path in sorted((self.root / room).rglob("*"))
            if path.suffix in CODE
        ]
        self.embedded = {identifier(Path(f).name): f for f in self.files if f.endswith(".glsl")}
        self.arrows = [(f, target) for f in self.files for target in self.targets(f)]

    def targets(self, file):
        text = (self.root / file).read_text(errors="replace")
        includes = re.findall(r'^\s*#\s*include "([^"]+)"', text, re.M)
        shaders = re.findall(r"oit_glsl::(\w+_glsl)\b", text)
        rooms = [i for i in includes if i.split("/")[0] in self.rooms]
        return rooms + [self.embedded.get(s, f"oit_glsl::{s}") for s in shaders]

    def entry(self, file):
        """A file's place in its room's ORDER: its sub-room, or its own stem at the top."""
        parts = file.split("/")
        return parts[1] if len(parts) > 2 else parts[1].split(".")[0]


def missing_files(tree):
    known = set(tree.files)
    return [f"{f}: includes {t}, which is not there" for f, t in tree.arrows if t not in known]


def arrows_between_rooms(tree):
    """Against the order of the rooms; groundtruth and oit stand side by side."""
    errors = []
    for file, target in tree.arrows:
        room, other = file.split("/")[0], target.split("/")[0]
        if other not in tree.rooms:
            continue
        up = tree.rooms.index(other) > tree.rooms.index(room)
        if up or (room, other) == ("oit", "groundtruth"):
            errors.append(f"{file}: {target}: {room} may not include {other}")
    return errors


def arrows_inside_rooms(tree):
    errors = []
    for file, target in tree.arrows:
        room = file.split("/")[0]
        if target.split("/")[0] != room or not is_ordered(tree.cmake[room]):
            continue
        order = declared(tree.cmake[room], "ORDER")
        at, other = tree.entry(file), tree.entry(target)
        if at in order and other in order and order.index(other) > order.index(at):
            errors.append(f"{file}: {target}: in {room}, {at} comes before {other}")
    return errors


def entries_without_place(tree):
    errors = []
    for room in tree.rooms:
        if not is_ordered(tree.cmake[room]):
            continue
        order = declared(tree.cmake[room], "ORDER")
        there = {tree.entry(f) for f in tree.files if f.startswith(room + "/")}
        errors += [f"{room}/CMakeLists.txt: ORDER lacks {e}" for e in sorted(there - set(order))]
        errors += [f"{room}/CMakeLists.txt: ORDER names {e}, which is not there"
                   for e in order if e not in there]
    return errors


def circles_of_folders(tree):
    """Among the folders inside a sub-room."""
    graph = {}
    for file, target in tree.arrows:
        a, b = str(Path(file).parent), str(Path(target).parent)
        deep = a.count("/") >= 2 and b.count("/") >= 2
        if a != b and deep and a.split("/")[:2] == b.split("/")[:2]:
            graph.setdefault(a, set()).add(b)
    errors = []
    while graph:
        free = [a for a, to in graph.items() if not to & graph.keys()]
        if not free:
            return errors + [f"a circle among the folders {', '.join(sorted(graph))}"]
        for a in free:
            del graph[a]
    return errors


def declarations(tree):
    """ROOMS of a room's CMakeLists.txt against what it includes."""
    errors = []
    for room in tree.rooms:
        said = declared_rooms(tree.cmake[room]) & set(tree.rooms)
        used = {t.split("/")[0] for f, t in tree.arrows if f.startswith(room + "/")}
        used = (used & set(tree.rooms)) - {room}
        up = [r for r in said if tree.rooms.index(r) >= tree.rooms.index(room)]
        errors += [f"{room}/CMakeLists.txt: ROOMS {r}: {room} may not include it" for r in up]
        errors += [f"{room}/CMakeLists.txt: ROOMS lacks {r}" for r in sorted(used - said)]
        errors += [f"{room}/CMakeLists.txt: ROOMS {r}: nothing of it is included"
                   for r in sorted(said - used - set(up))]
    return errors


def full_folders(tree):
    counts = {}
    for file in tree.files:
        folder = str(Path(file).parent)
        counts[folder] = counts.get(folder, 0) + 1
    return [f"{folder}: {n} code files; at most {MOST_FILES}"
            for folder, n in counts.items() if n > MOST_FILES]


CHECKS = [missing_files, arrows_between_rooms, arrows_inside_rooms, entries_without_place,
          circles_of_folders, declarations, full_folders]


def errors_of(root):
    tree = Tree(root)
    return tree, [error for check in CHECKS for error in check(tree)]


def main():
    tree, errors = errors_of(sys.argv[1])
    for error in errors:
        print(error, file=sys.stderr)
    if len(tree.arrows) < 100:
        errors.append("too few")
        print(f"only {len(tree.arrows)} arrows found: the check looks in the wrong place",
              file=sys.stderr)
    print(f"{len(tree.arrows)} arrows between {len(tree.files)} files, {len(errors)} wrong")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
