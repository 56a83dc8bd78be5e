# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes from NumPy's arrays against closed forms, and against the program's own pictures."""

import json
import os
import subprocess
import threading

import numpy as np
import pellucid
import pytest
from sheets import CAMERA, sheet, stack

PROGRAM = os.environ["PELLUCID_PROGRAM"]


@pytest.mark.parametrize("count", [1, 2, 7])
@pytest.mark.parametrize("alpha", [0.0, 0.25, 1.0])
def test_n_layers_let_their_product_through(count, alpha):
    picture = stack([alpha] * count).render("raytrace")
    through = (1 - alpha) ** count
    expected = [c * (1 - through) + through for c in (0.25, 0.5, 0.75)] + [1 - through]
    # The picture is float: half an ulp of 1.
    assert np.abs(picture.image - np.array(expected)).max() <= 2.0**-24
    assert (picture.layers == count).all()  # α = 1 hides nothing that is not `opaque`


def test_pictures_have_rows_of_columns_of_rgba():
    picture = stack([0.5], resolution=(24, 16)).render()
    assert picture.image.shape == (16, 24, 4) and picture.image.dtype == np.float32
    assert picture.layers.shape == (16, 24) and picture.layers.dtype == np.uint32


def test_row_0_is_the_top():
    half = pellucid.Mesh([[-2, 0, 0], [2, 0, 0], [2, 2, 0], [-2, 2, 0]], [[0, 1, 2], [0, 2, 3]])
    scene = pellucid.load_scene({"camera": CAMERA, "resolution": (8, 8), "objects": [{"mesh": half}]})
    assert (scene.render().layers[:4] == 1).all() and (scene.render().layers[4:] == 0).all()


def write_scene(folder, meshes):
    """The same scene as files."""
    for i, mesh in enumerate(meshes):
        mesh.save(folder / f"{i}.ply")
    scene = {"format": "pellucid-scene", "version": 1, "camera": CAMERA, "resolution": [32, 24],
             "objects": [{"mesh": f"{i}.ply"} for i in range(len(meshes))]}
    (folder / "scene.json").write_text(json.dumps(scene))
    return scene


@pytest.mark.parametrize("method", ["raytrace", "weighted-average", "linked-list"])
def test_the_program_draws_the_same_picture(tmp_path, method):
    rng = np.random.default_rng(5)
    meshes = [pellucid.Mesh(rng.uniform(-1, 1, (30, 3)).astype(np.float32), rng.integers(0, 30, (40, 3)),
                            colors=rng.uniform(0, 1, (30, 4)).astype(np.float32)) for _ in range(3)]
    scene = write_scene(tmp_path, meshes)
    subprocess.run([PROGRAM, "render", tmp_path / "scene.json", "-m", method, "-o", tmp_path / "a.exr",
                    "--quiet"], check=True, capture_output=True)
    scene["objects"] = [{"mesh": mesh} for mesh in meshes]
    for loaded in pellucid.load_scene(scene), pellucid.load_scene(tmp_path / "scene.json"):
        picture = loaded.render(method)
        assert pellucid.compare(tmp_path / "a.exr", picture)["max_error"] == 0
        assert picture.stats["method"] == method and picture.stats["fragments"] == picture.layers.sum()


def test_objects_are_added_as_they_are_loaded():
    whole = stack([0.5, 0.25, 0.75])
    grown = stack([0.5])
    grown.add(sheet(-0.1, (0.25, 0.5, 0.75, 0.25)))
    grown.add({"mesh": sheet(-0.2, (0, 0, 0, 1))}, opacity=0.75, color=[0.25, 0.5, 0.75], name="last")
    assert grown.objects[-1] == "last" and len(grown.objects) == 3
    assert (grown.render().image == whole.render().image).all()


def test_a_wrong_object_leaves_the_scene_as_it_was():
    scene = stack([0.5])
    with pytest.raises(pellucid.InputError, match="opacity.*accepted: 0"):
        scene.add(sheet(0, (0, 0, 0, 1)), opacity=2)
    with pytest.raises(pellucid.InputError, match="resolution"):
        scene.resolution = (0, 5)
    assert len(scene.objects) == 1 and scene.resolution == [24, 16]


def test_lines_and_points_take_their_width_from_the_scene():
    line = pellucid.Lines([[-2, 0, 0], [2, 0, 0]])
    point = pellucid.Points([[0, 0.75, 0]], colors=np.array([[255, 0, 0, 128]], dtype=np.uint8))
    scene = pellucid.load_scene({"camera": CAMERA, "resolution": (16, 16),
                                 "objects": [{"lines": line, "radius": 0.25}]})
    scene.add(point, radius=0.1)
    layers = scene.render().layers
    assert (layers[6:10] == 1).all() and layers.sum() == 4 * 16 + (layers[:6] == 1).sum()
    assert scene.render().image[2, 8].tolist() == pytest.approx([1, 127 / 255, 127 / 255, 128 / 255])


def test_a_scalar_gives_the_radius_of_each_point():
    line = pellucid.Lines([[-1, 0, 0], [1, 0, 0]], scalars={"thickness": np.array([0.5, 0])})
    scene = pellucid.load_scene({"camera": CAMERA, "resolution": (64, 64),
                                 "objects": [{"lines": line, "radius": {"by": "thickness"}}]})
    x, y = np.meshgrid((np.arange(64) + 0.5) / 32 - 1, (np.arange(64) + 0.5) / 32 - 1)
    assert ((scene.render().layers == 1) == (abs(y) < 0.25 * (1 - x))).all()
    with pytest.raises(pellucid.InputError, match="unknown scalar 'thick'; known: thickness"):
        scene.add(line, radius={"by": "thick"})


def test_a_camera_that_is_not_given_is_fitted_again():
    scene = pellucid.load_scene({"objects": [{"mesh": sheet(0, (0, 0, 0, 1))}]})
    near = scene.camera["eye"]
    scene.add(sheet(0, (0, 0, 0, 1), half=50))
    assert np.linalg.norm(scene.camera["eye"]) > 10 * np.linalg.norm(near)
    scene.camera = CAMERA
    scene.add(sheet(0, (0, 0, 0, 1), half=500))
    assert scene.camera["height"] == 2 and scene.camera["type"] == "orthographic"


def test_arrays_are_views_that_outlive_their_owner():
    picture = stack([0.5]).render()
    image, again = picture.image, picture.image
    assert np.shares_memory(image, again)
    expected = image.copy()
    del picture, again
    stack([0.25] * 3).render()  # would take the memory if it were free
    assert (image == expected).all()


def test_a_mesh_does_not_follow_its_arrays_and_cannot_be_written():
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    mesh = pellucid.Mesh(vertices, [[0, 1, 2]], scalars={"speed": [1, 2, 3]})
    vertices[:] = 7
    assert mesh.vertices[1].tolist() == [1, 0, 0] and mesh.scalars["speed"].tolist() == [1, 2, 3]
    assert np.shares_memory(mesh.vertices, mesh.vertices)
    with pytest.raises(ValueError):
        mesh.vertices[0, 0] = 1


def test_a_notebook_shows_a_png_of_the_size():
    png = stack([0.5], resolution=(24, 16)).render()._repr_png_()
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert int.from_bytes(png[16:20], "big") == 24 and int.from_bytes(png[20:24], "big") == 16


def test_optimized_opacities_are_composited():
    mesh = pellucid.Mesh(sheet(0, (0, 0, 0, 1)).vertices, [[0, 1, 2], [0, 2, 3]], importance=[0.5] * 4)
    front = pellucid.Mesh(sheet(1, (0, 0, 0, 1)).vertices, [[0, 1, 2], [0, 2, 3]], importance=[0.1] * 4)
    scene = pellucid.load_scene({"camera": CAMERA, "resolution": (16, 16),
                                 "objects": [{"mesh": mesh}, {"mesh": front}]})
    plain = scene.render("raytrace")
    optimized = scene.render("raytrace", opacities="decoupled-lists")
    assert optimized.stats["opacities"] == "decoupled-lists"
    assert pellucid.compare(plain, optimized)["rmse"] > 0.01


def test_a_change_while_another_thread_renders_is_refused_or_waits():
    scene = stack([0.5] * 40, resolution=(512, 512))
    before = scene.render(warm_up=False).layers.sum()
    pictures = []
    thread = threading.Thread(target=lambda: pictures.append(scene.render("raytrace")))
    thread.start()
    while thread.is_alive():
        try:
            scene.samples = 1
        except pellucid.WorkError as error:
            assert "another thread" in str(error)
    thread.join()
    assert pictures[0].layers.sum() == before


def test_saved_pictures_say_what_they_are_of(tmp_path):
    scene = stack([0.5])
    scene.render("weighted-average").save(tmp_path / "a.exr")
    text = (tmp_path / "a.exr").read_bytes()
    assert all(word in text for word in (b"Software", b"weighted-average", b"Camera", b"A = 1 - transmittance"))


def test_stats_are_those_of_the_program(tmp_path):
    scene = write_scene(tmp_path, [sheet(0, (0.5, 0.2, 0.1, 0.5))])
    subprocess.run([PROGRAM, "render", tmp_path / "scene.json", "-m", "raytrace", "-o", tmp_path / "a.exr", "--quiet",
                    "--stats", tmp_path / "a.json"], check=True, capture_output=True)
    written = json.loads((tmp_path / "a.json").read_text())
    stats = pellucid.load_scene(tmp_path / "scene.json").render("raytrace").stats
    assert set(stats) == set(written) and stats["view"] == written["view"]
    assert stats["view"]["resolution"] == scene["resolution"]
