# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong input of any kind is an InputError; nothing crashes the interpreter."""

import pathlib
import random
import resource

import numpy as np
import pellucid
import pytest
from sheets import CAMERA, sheet, stack

TRIANGLE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
NAN = float("nan")


def mesh_scene(**keys):
    return pellucid.load_scene({"objects": [{"mesh": sheet(0, (0, 0, 0, 1))}], **keys})


WRONG = {
    "an index beyond the vertices": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 3]]),
    "a negative index": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, -1]]),
    "an index of 2^40": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2**40]]),
    "an index of 2^64 - 1": lambda: pellucid.Mesh(TRIANGLE, np.array([[0, 1, 2**64 - 1]], dtype=np.uint64)),
    "indices of floats": lambda: pellucid.Mesh(TRIANGLE, [[0.0, 1.0, 2.0]]),
    "no triangle": lambda: pellucid.Mesh(TRIANGLE, np.zeros((0, 3), dtype=int)),
    "no vertex": lambda: pellucid.Mesh(np.zeros((0, 3)), [[0, 1, 2]]),
    "two coordinates": lambda: pellucid.Mesh([[0, 0], [1, 0]], [[0, 1, 1]]),
    "a coordinate that is not finite": lambda: pellucid.Mesh([[NAN, 0, 0]] * 3, [[0, 1, 2]]),
    "ragged vertices": lambda: pellucid.Mesh([[0, 0, 0], [1]], [[0, 1, 2]]),
    "a list of masked rows": lambda: pellucid.Mesh([np.ma.masked_array(row, [0, 1, 0]) for row in TRIANGLE], [[0, 1, 2]]),
    "complex vertices": lambda: pellucid.Mesh(np.zeros((3, 3), dtype=complex), [[0, 1, 2]]),
    "texts as vertices": lambda: pellucid.Mesh([["a", "b", "c"]] * 3, [[0, 1, 2]]),
    "None as vertices": lambda: pellucid.Mesh(None, [[0, 1, 2]]),
    "colours beyond 1": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], colors=[[2.0, 0, 0]] * 3),
    "too few colours": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], colors=[[0.5, 0, 0]] * 2),
    "five channels": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], colors=np.zeros((3, 5))),
    "importance below 0": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], importance=[0, -1, 0]),
    "scalars without names": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], scalars=[1, 2, 3]),
    "too few scalars": lambda: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], scalars={"a": [1, 2]}),
    "offsets that descend": lambda: pellucid.Lines(TRIANGLE, [0, 2, 1, 3]),
    "offsets beyond the vertices": lambda: pellucid.Lines(TRIANGLE, [0, 5]),
    "offsets below 0": lambda: pellucid.Lines(TRIANGLE, [-1, 3]),
    "a mesh as lines": lambda: mesh_scene(objects=[{"lines": sheet(0, (0, 0, 0, 1)), "radius": 1}]),
    "points as a mesh": lambda: mesh_scene(objects=[{"mesh": pellucid.Points(TRIANGLE)}]),
    "lines without a segment": lambda: mesh_scene(objects=[{"lines": pellucid.Lines(TRIANGLE[:1]), "radius": 1}]),
    "lines without a radius": lambda: mesh_scene(objects=[{"lines": pellucid.Lines(TRIANGLE)}]),
    "a scene without objects": lambda: mesh_scene(objects=[]),
    "objects that are none": lambda: mesh_scene(objects=3),
    "an unknown key": lambda: mesh_scene(colour="red"),
    "a key that is no text": lambda: pellucid.load_scene({3: 4}),
    "a number that is not finite": lambda: mesh_scene(background=[NAN, 0, 0]),
    "a number of 2^70": lambda: mesh_scene(samples=2**70),
    "a set": lambda: mesh_scene(samples={1}),
    "a name that stands for a shape": lambda: mesh_scene(objects=[{"mesh": "<pellucid mesh 0>"}]),
    "a scene that is a number": lambda: pellucid.load_scene(5),
    "a scene that is nothing": lambda: pellucid.load_scene(None),
    "a scene file that is not there": lambda: pellucid.load_scene(pathlib.Path("nowhere.json")),
    "a text of lone surrogates": lambda: pellucid.load_scene("\ud800"),
    "an unknown method": lambda: stack([0.5]).render("raytracing"),
    "a method that is a number": lambda: stack([0.5]).render(5),
    "an unknown parameter": lambda: stack([0.5]).render("fourier:band=5"),
    "a parameter out of range": lambda: stack([0.5]).render("fourier:bands=-5"),
    "an unknown platform of GL": lambda: stack([0.5]).render("fourier", gl="vulkan"),
    "opacities without importance": lambda: stack([0.5]).render(opacities="decoupled-lists"),
    "a pixel outside": lambda: stack([0.5]).crossings(24, 0),
    "a pixel of a half": lambda: stack([0.5]).crossings(0.5, 0),
    "a deep picture of samples": lambda: mesh_scene(samples=2).deep(),
    "pictures of two sizes": lambda: pellucid.compare(np.zeros((4, 4, 3)), np.zeros((4, 5, 3))),
    "pictures without pixels": lambda: pellucid.compare(np.zeros((0, 4, 3)), np.zeros((0, 4, 3))),
    "a picture that is not finite": lambda: pellucid.compare(np.full((4, 4, 3), NAN), np.zeros((4, 4, 3))),
    "a mask of another size": lambda: pellucid.compare(np.zeros((4, 4, 3)), np.zeros((4, 4, 3)), np.ones((4, 5))),
    "a mask without a pixel": lambda: pellucid.compare(np.zeros((4, 4, 3)), np.zeros((4, 4, 3)), np.zeros((4, 4))),
    "a grey picture": lambda: pellucid.compare(np.zeros((4, 4)), np.zeros((4, 4))),
    "a picture file that is not there": lambda: pellucid.compare("nowhere.png", np.zeros((4, 4, 3))),
    "a picture of another ending": lambda: stack([0.5]).render().save("picture.bmp"),
    "a mesh of another ending": lambda: sheet(0, (0, 0, 0, 1)).save("mesh.bmp"),
    "an unknown field": lambda: pellucid.trace("abd", "hultquist", TRIANGLE, 1),
    "an unknown integrator": lambda: pellucid.trace("abc", "hultquists", TRIANGLE, 1),
    "a seed of one point": lambda: pellucid.trace("abc", "hultquist", TRIANGLE[:1], 1),
    "a seed of none": lambda: pellucid.trace("abc", "stream-lines", np.zeros((0, 3)), 1),
    "a duration that is not finite": lambda: pellucid.trace("abc", "hultquist", TRIANGLE, NAN),
    "a duration that is text": lambda: pellucid.trace("abc", "hultquist", TRIANGLE, "long"),
    "an unknown study": lambda: pellucid.run_study("quickstarted", "out"),
}


@pytest.mark.parametrize("what", WRONG)
def test_wrong_input_is_an_input_error_of_one_line(what, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(pellucid.InputError) as raised:
        WRONG[what]()
    assert "\n" not in str(raised.value) and len(str(raised.value)) > 10
    assert not list(tmp_path.iterdir())


def test_a_limit_of_a_files_size_is_like_a_full_disk(tmp_path):
    picture = stack([0.5]).render()
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (512, before[1]))
    try:
        with pytest.raises(pellucid.WorkError, match="File too large"):
            picture.save(tmp_path / "a.exr")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert not list(tmp_path.iterdir())


def test_errors_are_also_pythons_own():
    assert issubclass(pellucid.InputError, ValueError) and issubclass(pellucid.WorkError, RuntimeError)


def nested(levels):
    value = []
    for _ in range(levels):
        value = [value]
    return value


class Hostile:
    """Raises wherever it is asked."""

    def __getattr__(self, name):
        raise RuntimeError(name)

    def __index__(self):
        raise RuntimeError("index")

    def __float__(self):
        raise RuntimeError("float")


def junk():
    return [None, True, -1, 0, 2**63, 2**100, 1.5, NAN, float("inf"), "", "abc", "raytrace", "\ud800", "a\0b", b"x", [],
            {}, (1, 2), [[1, 2, 3]], nested(2000), {"objects": nested(150)}, np.zeros((2, 3)), np.zeros((0, 0, 3)),
            np.array(5), np.array(None), np.array(["x"]), np.zeros(3, dtype=[("a", int)]), range(3), object(),
            Hostile(), sheet(0, (0, 0, 0, 1)), pellucid.Points(TRIANGLE), {"mesh": 5}, {"objects": [{"mesh": 1e400}]},
            pathlib.Path("."), np.float32(2), np.int8(3), np.full((3, 3), np.inf), np.zeros((2, 3))[:, ::-1]]


def functions(scene, picture):
    return [(pellucid.Mesh, 2), (pellucid.Lines, 2), (pellucid.Points, 1), (pellucid.load_scene, 1), (scene.add, 1),
            (lambda x, y: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], colors=x, scalars=y), 2),
            (lambda x, y: pellucid.Mesh(TRIANGLE, [[0, 1, 2]], normals=x, importance=y), 2),
            (scene.render, 1), (scene.crossings, 2), (pellucid.compare, 2), (pellucid.trace, 4),
            (lambda x: pellucid.run_study(x, "out", only="no/such"), 1), (picture.save, 1),
            (lambda x: setattr(scene, "camera", x), 1), (lambda x: setattr(scene, "resolution", x), 1),
            (lambda x: setattr(scene, "background", x), 1), (lambda x: scene.add({"mesh": x}), 1),
            (lambda x: scene.add(sheet(0, (0, 0, 0, 1)), color=x, opacity=x), 1)]


def test_junk_is_refused(tmp_path, monkeypatch):
    """Whatever is given: done, or an InputError; a TypeError is for the number of arguments alone, RuntimeErrors
    are those that Hostile raises."""
    monkeypatch.chdir(tmp_path)
    rng = random.Random(7)
    scene = pellucid.load_scene({"camera": CAMERA, "resolution": (8, 8), "objects": [{"mesh": sheet(0, (0, 0, 0, 1))}]})
    picture = scene.render()
    refused = 0
    for function, count in functions(scene, picture):
        for _ in range(60):
            arguments = [rng.choice(junk()) for _ in range(count)]
            try:
                function(*arguments)
            except pellucid.InputError as error:
                assert "\n" not in str(error)
                refused += 1
            except RuntimeError as error:
                assert any(isinstance(a, Hostile) for a in arguments), (function, arguments, error)
    assert refused > 300


def test_masked_values_are_not_dropped_in_silence():
    triangle = np.ma.masked_array(TRIANGLE, mask=[[0, 0, 0], [0, 1, 0], [0, 0, 0]])
    picture = np.ma.masked_less(np.zeros((4, 4, 3), dtype=np.float32), 1)
    scene = pellucid.load_scene({"objects": [{"mesh": sheet(0, (0, 0, 0, 1))}]})
    for call in (lambda: pellucid.Points(triangle), lambda: pellucid.compare(picture, picture.data),
                 lambda: pellucid.compare(picture.data, picture.data, mask=picture[..., 0]),
                 lambda: setattr(scene, "background", np.ma.masked_array([0.0, 0.5, 1.0], mask=[1, 0, 0]))):
        with pytest.raises(pellucid.InputError, match="masked"):
            call()
    assert len(pellucid.Points(np.ma.masked_array(TRIANGLE)).vertices) == 3  # nothing is masked


def test_an_index_is_told_as_it_was_given():
    with pytest.raises(pellucid.InputError, match=r"triangles: 18446744073709551615; accepted"):
        pellucid.Mesh(TRIANGLE, np.array([[0, 1, 2**64 - 1]], dtype=np.uint64))


def test_a_message_begins_with_a_name_or_with_what_is_wrong():
    scene = pellucid.load_scene({"objects": [{"mesh": sheet(0, (0, 0, 0, 1))}]})
    with pytest.raises(pellucid.InputError, match=r"^[a-z]") as refused:
        scene.render("weighted-sum", opacities="fourier-opacity")
    assert not str(refused.value).startswith(":")
    with pytest.raises(pellucid.InputError, match=r"^Mesh: no triangles"):
        pellucid.Mesh(TRIANGLE, np.zeros((0, 3), dtype=int))


def test_a_mask_holds_numbers_alone():
    picture = np.zeros((16, 16, 3), dtype=np.float32)
    with pytest.raises(pellucid.InputError, match="mask: not a number"):
        pellucid.compare(picture, picture, mask=np.full((16, 16), NAN))
