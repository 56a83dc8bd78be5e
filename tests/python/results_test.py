# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison, surfaces and studies."""

import csv
import json
import math
import os
import subprocess

import numpy as np
import pellucid
import pytest
from sheets import sheet

PROGRAM = os.environ["PELLUCID_PROGRAM"]


def test_a_constant_difference_is_the_rmse():
    a = np.full((32, 40, 3), 0.25, dtype=np.float32)
    metrics = pellucid.compare(a, a + np.float32(0.125))
    assert metrics["rmse"] == 0.125 and metrics["max_error"] == 0.125
    assert metrics["psnr"] == pytest.approx(20 * math.log10(8))
    assert pellucid.compare(a, a)["psnr"] == math.inf and pellucid.compare(a, a)["ssim"] == 1
    assert pellucid.compare(a[:5, :5], a[:5, :5])["ssim"] is None


def test_a_mask_says_which_pixels_count():
    a = np.zeros((16, 16, 3), dtype=np.float32)
    b = a.copy()
    b[:, 8:] = 0.5
    mask = np.zeros((16, 16), dtype=bool)
    mask[:, 8:] = True
    white = np.repeat(mask[..., None], 3, axis=2).astype(np.float32)
    assert pellucid.compare(a, b, mask)["rmse"] == pellucid.compare(a, b, mask=white)["rmse"] == 0.5
    assert pellucid.compare(a, b, ~mask)["rmse"] == 0
    assert pellucid.compare(a, b, mask.tolist())["rmse"] == pellucid.compare(a, b, mask[..., None])["rmse"] == 0.5


def test_a_negative_duration_goes_the_way_back():
    for integrator in ("fixed-front:particles=3", "hultquist:particles=3", "adaptive-front:particles=3"):
        surface = pellucid.trace("formula:u=1,v=0,w=0", integrator, [[0, 0, 0], [0, 1, 0]], -2)
        assert surface.vertices[:, 0].min() == pytest.approx(-2) and surface.vertices[:, 0].max() == 0
        assert surface.scalars["t"].min() == pytest.approx(-2)


def test_a_fitted_camera_stays_what_the_loader_fits():
    near, far = sheet(0, (0.5, 0.2, 0.1, 0.5)), sheet(7, (0.1, 0.2, 0.5, 0.5))
    both = pellucid.load_scene({"resolution": (64, 48), "objects": [{"mesh": near}, {"mesh": far}]})
    camera = both.camera
    both.background = both.background
    assert both.camera == camera
    grown = pellucid.load_scene({"resolution": (64, 48), "objects": [{"mesh": near}]})
    grown.add(far)
    assert grown.camera == camera


def test_what_is_added_is_found_beside_the_scene(tmp_path):
    sheet(0, (0.5, 0.2, 0.1, 0.5)).save(tmp_path / "near.ply")
    sheet(3, (0.5, 0.2, 0.1, 0.5)).save(tmp_path / "far.ply")
    (tmp_path / "scene.json").write_text('{"format": "pellucid-scene", "version": 1, "resolution": [32, 24],'
                                         ' "objects": [{"mesh": "near.ply"}]}')
    scene = pellucid.load_scene(tmp_path / "scene.json")
    before = scene.camera
    scene.add({"mesh": "far.ply"})
    assert len(scene.objects) == 2 and scene.camera != before
    with pytest.raises(pellucid.InputError, match="add: mesh: the object has one"):
        scene.add(sheet(1, (0.5, 0.2, 0.1, 0.5)), mesh="far.ply")


def test_any_mapping_and_any_sequence_will_do():
    from types import MappingProxyType
    scene = pellucid.load_scene(MappingProxyType({"resolution": (16, 16), "objects": [
        MappingProxyType({"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))})]}))
    picture = scene.render()
    lists = picture.image.tolist()
    assert pellucid.compare(lists, picture.image)["rmse"] == 0
    with pytest.raises(pellucid.InputError):
        pellucid.compare(lists, lists, mask=[[1, 2], [3]])


def draw_in_fork(queue):
    try:
        pellucid.load_scene({"resolution": (16, 16), "objects": [{"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))}]}).render(
            "weighted-sum")
        queue.put("drawn")
    except pellucid.WorkError as error:
        queue.put(str(error))


def test_a_forked_process_is_told_that_opengl_does_not_follow():
    import multiprocessing
    here = pellucid.load_scene({"resolution": (16, 16), "objects": [{"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))}]})
    here.render("weighted-sum")
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=draw_in_fork, args=(queue,))
    child.start()
    try:
        assert "before this process was forked" in queue.get(timeout=60)
    finally:
        child.kill()


def test_layers_tell_covered_pixels():
    scene = pellucid.load_scene({"resolution": (64, 48), "objects": [{"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))}]})
    exact = scene.render()
    brighter = np.array(exact.image) + np.float32(0.25)
    assert pellucid.compare(exact, brighter)["rmse_covered"] == pytest.approx(0.25, rel=1e-6)  # float's rounding
    assert pellucid.compare(exact.image, brighter).get("rmse_covered") is None


def test_bytes_are_n_of_255():
    a = np.zeros((16, 16, 3), dtype=np.uint8)
    assert pellucid.compare(a, a + np.uint8(51))["rmse"] == pytest.approx(0.2, rel=1e-7)


def test_the_program_measures_the_same(tmp_path):
    rng = np.random.default_rng(3)
    scene = pellucid.load_scene({"resolution": (64, 48), "objects": [{"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))}]})
    picture = scene.render()
    picture.save(tmp_path / "a.exr")
    picture.image[..., :3] = rng.uniform(0, 1, (48, 64, 3))
    picture.save(tmp_path / "b.exr")
    printed = subprocess.run([PROGRAM, "compare", tmp_path / "a.exr", tmp_path / "b.exr", "--json"], check=True,
                             capture_output=True, text=True).stdout
    numbers = json.loads(printed)
    assert pellucid.compare(tmp_path / "a.exr", picture) == numbers


def test_compare_says_what_looks_wrong_with_a_picture():
    scene = pellucid.load_scene({"resolution": (64, 48), "objects": [{"mesh": sheet(0, (0.5, 0.2, 0.1, 0.5))}],
                                 "camera": {"eye": [1.2, 0.7, 3], "target": [0.4, 0.6, 0], "fov": 50}})
    image = scene.render().image
    assert pellucid.compare(image, image)["faults"] == []
    turned = pellucid.compare(image, image[::-1].copy())
    assert len(turned["faults"]) == 1 and turned["reference_faults"] == []
    assert "upside down" in turned["faults"][0]
    assert pellucid.compare(image, image[::-1].copy(), mask=np.ones((48, 64)))["faults"] == []


def test_every_metric_of_the_table_is_there():
    listed = subprocess.run([PROGRAM, "list", "metrics", "--json"], check=True, capture_output=True, text=True)
    names = {row["name"] for row in json.loads(listed.stdout)}
    a = np.zeros((200, 200, 3), dtype=np.float32)
    assert {"rmse", "psnr", "ssim", "max_error"} <= names & set(pellucid.compare(a, a))


def test_a_uniform_flow_sweeps_a_plane():
    surface = pellucid.trace("formula:u=0,v=2,w=0", "fixed-front:particles=5", [[0, 0, 0], [3, 0, 0]], 0.5,
                             samples=50)
    corners = surface.vertices[surface.triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert areas.sum() == pytest.approx(3, rel=1e-12)
    assert np.abs(surface.vertices[:, 2]).max() == 0 and np.abs(surface.normals[:, 2]).min() == 1
    assert surface.scalars["speed"] == pytest.approx(np.full(len(surface.vertices), 2))
    assert surface.quality["triangles"] == len(surface.triangles)
    assert surface.quality["distance"]["max"] < 1e-9
    scene = pellucid.load_scene({"objects": [{"mesh": surface, "color": {"by": "t", "map": "viridis"}}]})
    assert scene.render().layers.max() == 1


def test_streak_and_time_surfaces_of_a_uniform_flow():
    line = [[0, 0, 0], [3, 0, 0]]
    streak = pellucid.trace("formula:u=0,v=2,w=0", "streak-surface", line, 0.5, samples=50)
    assert streak.vertices[:, 1].max() == pytest.approx(1) and streak.quality["distance"]["max"] < 1e-9
    assert streak.scalars["released"] == pytest.approx(0.5 - streak.scalars["t"])
    patch = pellucid.trace("formula:u=0,v=2,w=0", "time-surface", [*line, [0, 0, 1]], 0.5)
    assert patch.vertices[:, 1] == pytest.approx(np.full(len(patch.vertices), 1))
    with pytest.raises(pellucid.InputError, match="time surface"):
        pellucid.trace("formula:u=0,v=2,w=0", "time-surface", line, 0.5)


def test_attributes_of_a_file_are_carried_along(tmp_path):
    flow = tmp_path / "flow.vtk"
    flow.write_text("# vtk DataFile Version 3.0\nflow\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
                    "ORIGIN 0 0 0\nSPACING 4 4 4\nPOINT_DATA 8\nVECTORS U float\n" + "0 1 0 " * 8 +
                    "\nSCALARS p float 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n")  # p = (x + 2 y + 4 z) / 4
    line = [[1, 0, 1], [2, 0, 1]]
    for made in (pellucid.trace(flow, "hultquist:particles=3", line, 2, carry=["p"]),
                 pellucid.trace(flow, "streak-surface", line, 2, carry="p"),
                 pellucid.trace(flow, "stream-lines:particles=2", line, 2, carry=("p",))):
        assert made.scalars["p"] == pytest.approx(made.vertices @ [0.25, 0.5, 1], abs=1e-6)
    with pytest.raises(pellucid.InputError, match="no scalar 'T'.*p .point"):
        pellucid.trace(flow, "hultquist", line, 2, carry=["T"])
    with pytest.raises(pellucid.InputError, match="carry"):
        pellucid.trace(flow, "hultquist", line, 2, carry=3)


def test_lines_of_a_rotation_stay_on_circles():
    lines = pellucid.trace("formula:u=-y,v=x,w=0", "stream-lines:particles=4", [[1, 0, 0], [2, 0, 0]], 3)
    assert isinstance(lines, pellucid.Lines) and lines.stats["lines"] == 4
    for first, last in zip(lines.offsets[:-1], lines.offsets[1:]):
        radii = np.linalg.norm(lines.vertices[int(first):int(last)], axis=1)
        assert radii == pytest.approx(np.full(len(radii), radii[0]), rel=1e-4)


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    sheet(0, (0.2, 0.4, 0.6, 0.5)).save(folder / "sheet.ply")
    scene = {"format": "pellucid-scene", "version": 1, "resolution": [48, 48], "objects": [{"mesh": "sheet.ply"}]}
    (folder / "one.json").write_text(json.dumps(scene))
    text = {"format": "pellucid-study", "version": 1, "title": "One", "scenes": ["one.json"],
            "reference": "raytrace", "methods": ["weighted-average"], "repeats": 1}
    (folder / "study.json").write_text(json.dumps(text))
    return folder, pellucid.run_study(folder / "study.json", folder / "out")


def test_the_rows_are_those_of_the_table(study):
    folder, results = study
    with open(folder / "out/results.csv", newline="") as file:
        written = list(csv.DictReader(file))
    assert len(results.rows) == len(written) == 2
    for row, line in zip(results.rows, written):
        assert row["scene"] == line["scene"] == "one" and row["method"] == line["method"]
        for name in set(row) & set(line) - {"scene", "method", "parameters", "error"}:
            assert (line[name] == "") == (row[name] is None), name
            if row[name] is not None and math.isfinite(row[name]):
                assert float(line[name]) == pytest.approx(row[name], rel=1e-5), name
    assert (folder / "out/report.html").exists() and results.folder == str(folder / "out")


def test_rows_have_the_columns_of_the_table_and_no_other(study):
    folder, results = study
    with open(folder / "out/results.csv", newline="") as file:
        columns = set(csv.DictReader(file).fieldnames)
    assert all(set(row) == columns for row in results.rows)


def test_rows_become_a_data_frame(study):
    pandas = pytest.importorskip("pandas")
    frame = study[1].to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame["method"]) == ["raytrace", "weighted-average"]
    assert frame["rmse"].dtype.kind == "f"


def test_the_studies_that_come_with_the_program_are_found(tmp_path):
    with pytest.raises(pellucid.InputError, match="--only.*fits no cell"):
        pellucid.run_study("quickstart", tmp_path, only="nothing/fits")
