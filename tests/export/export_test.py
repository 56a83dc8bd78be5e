#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exported scenes hold what is drawn: export_test.py. The program is $PELLUCID_PROGRAM.

An independent renderer draws them as the program does; glTF's readers find the same geometry and colours in scene.glb."""

import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

import exr
import independent_renderer as independent

# The reference composites in double and is stored in floats: half an ulp of values below 1, and that of the positions'
# floats, which move a fragment's colour by less.
FLOAT_PICTURE = 2e-6

RANDOM = numpy.random.default_rng(20)


def write_ply(path, vertices, names, faces=(), edges=()):
    lines = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}", *(f"property float {name}" for name in names)]
    if len(edges):
        lines += [f"element edge {len(edges)}", "property int vertex1", "property int vertex2"]
    if len(faces):
        lines += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    lines += ["end_header"] + [" ".join(repr(float(x)) for x in row) for row in vertices.astype(numpy.float32)]
    lines += [" ".join(map(str, edge)) for edge in edges] + [f"3 {a} {b} {c}" for a, b, c in faces]
    Path(path).write_text("\n".join(lines) + "\n")


def colors(n):
    return numpy.concatenate([RANDOM.random((n, 3)), 0.1 + 0.8 * RANDOM.random((n, 1))], 1)


NAMES = "x y z red green blue alpha".split()


def random_mesh(path, triangles, normals=False):
    vertices = numpy.repeat(RANDOM.uniform(-1, 1, (triangles, 3)), 3, 0) + RANDOM.uniform(-0.6, 0.6, (3 * triangles, 3))
    table = numpy.concatenate([vertices, colors(3 * triangles)], 1)
    names = list(NAMES)
    if normals:
        n = numpy.repeat(RANDOM.normal(size=(triangles, 3)), 3, 0) if normals == "flat" else RANDOM.normal(size=vertices.shape)
        table = numpy.concatenate([table, n / numpy.linalg.norm(n, axis=1, keepdims=True)], 1)
        names += ["nx", "ny", "nz"]
    write_ply(path, table, names, numpy.arange(3 * triangles).reshape(-1, 3))


PERSPECTIVE = {"type": "perspective", "eye": [1.5, 1, 4], "target": [0.1, 0, 0], "fov": 40}
ORTHOGRAPHIC = {"type": "orthographic", "eye": [2, 1, 4], "target": [0, 0.1, 0], "height": 3}


class Exported(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def export(self, camera, objects, **more):
        scene = {"format": "pellucid-scene", "version": 1, "resolution": [61, 47], "camera": camera,
                 "background": [0.1, 0.5, 0.9], "objects": objects, **more}
        (self.folder / "scene.json").write_text(json.dumps(scene))
        done = subprocess.run([os.environ["PELLUCID_PROGRAM"], "export", self.folder / "scene.json", "-o",
                               self.folder / "out", "--quiet"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "out/scene.json").read_text())

    def assert_draws_the_same(self, covered_share=0.2):
        drawn = independent.render(self.folder / "out/scene.json")
        reference = exr.read(self.folder / "out/reference.exr")
        self.assertGreater((reference[..., 3] > 0).mean(), covered_share)
        off = abs(drawn - reference).max(-1)
        self.assertEqual(numpy.count_nonzero(off > FLOAT_PICTURE), 0, f"largest {off.max()}")

    def test_triangles_in_perspective(self):
        random_mesh(self.folder / "mesh.ply", 120)
        scene = self.export(PERSPECTIVE, [{"mesh": "mesh.ply"}])
        self.assertEqual(scene["objects"][0]["count"], 120)
        self.assert_draws_the_same()

    def test_everything_in_parallel(self):
        for kind in "mesh", "wall":
            random_mesh(self.folder / f"{kind}.ply", 30)
        line = numpy.cumsum(RANDOM.uniform(-0.3, 0.35, (24, 3)), 0)
        write_ply(self.folder / "lines.ply", numpy.concatenate([line, colors(24)], 1), NAMES,
                  edges=[(i, i + 1) for i in range(23) if i != 11])
        write_ply(self.folder / "points.ply", numpy.concatenate([RANDOM.uniform(-1, 1, (40, 3)), colors(40)], 1), NAMES)
        scene = self.export(ORTHOGRAPHIC, [{"mesh": "mesh.ply"}, {"lines": "lines.ply", "radius": 0.05},
                                           {"mesh": "wall.ply", "opaque": True}, {"points": "points.ply", "radius": 0.1}])
        self.assertEqual([thing["kind"] for thing in scene["objects"]], ["triangles", "lines", "triangles", "points"])
        self.assert_draws_the_same()

    def test_lines_and_points_in_perspective(self):
        line = numpy.stack([numpy.linspace(-1, 1, 30), numpy.sin(numpy.linspace(0, 9, 30)), numpy.cos(numpy.linspace(0, 7, 30))], 1)
        write_ply(self.folder / "lines.ply", numpy.concatenate([line, colors(30)], 1), NAMES,
                  edges=[(i, i + 1) for i in range(29)])
        write_ply(self.folder / "points.ply", numpy.concatenate([RANDOM.uniform(-1, 1, (20, 3)), colors(20)], 1), NAMES)
        self.export(PERSPECTIVE, [{"lines": "lines.ply", "radius": 0.1}, {"points": "points.ply", "radius": 0.2}])
        self.assert_draws_the_same(0.1)

    def test_points_that_are_there_twice_and_lines_that_turn_back_or_face_the_eye(self):
        for corners in ([0, 1, 1, 2, 3], [0, 0, 1, 2, 2], [0, 1, 1, 1, 3], [0, 2, 0, 3], [4, 5, 6, 3]):
            line = numpy.array([[-1, -0.5, 0], [-0.4, 0.4, 0.3], [0.2, -0.1, -0.2], [0.9, 0.5, 0.1],
                                [0, 0, -1], [0, 0, 0], [0, 0, 0.5]])[corners]
            n = len(line)
            write_ply(self.folder / "lines.ply", numpy.concatenate([line, colors(n)], 1), NAMES, edges=[(i, i + 1) for i in range(n - 1)])
            for camera in ({"type": "perspective", "eye": [0, 0, 4], "target": [0, 0, 0], "fov": 50},
                           {"type": "orthographic", "eye": [0, 0, 4], "target": [0, 0, 0], "height": 3}):
                self.export(camera, [{"lines": "lines.ply", "radius": 0.2}], resolution=[60, 46])
                self.assert_draws_the_same(0.01)

    def test_radii_of_each_point(self):
        line = numpy.stack([numpy.linspace(-1, 1, 30), numpy.sin(numpy.linspace(0, 9, 30)), numpy.cos(numpy.linspace(0, 7, 30))], 1)
        names = [*NAMES, "thickness"]
        write_ply(self.folder / "lines.ply", numpy.concatenate([line, colors(30), numpy.linspace(0, 0.4, 30)[:, None]], 1), names,
                  edges=[(i, i + 1) for i in range(29)])
        write_ply(self.folder / "points.ply", numpy.concatenate(
            [RANDOM.uniform(-1, 1, (20, 3)), colors(20), numpy.maximum(0, RANDOM.uniform(-0.05, 0.3, (20, 1)))], 1), names)
        for camera in PERSPECTIVE, ORTHOGRAPHIC:
            scene = self.export(camera, [{"lines": "lines.ply", "radius": {"by": "thickness", "scale": 0.5}},
                                         {"points": "points.ply", "radius": {"by": "thickness"}},
                                         {"points": "points.ply", "radius": 0.05}], lighting="headlight")
            self.assertEqual([thing["radius"] for thing in scene["objects"]], [None, None, 0.05])
            radii = independent.read_ply(self.folder / "out/object-0.ply")["vertex"]["radius"]
            numpy.testing.assert_allclose(radii, numpy.linspace(0, 0.2, 30), rtol=1e-6)
            self.assert_draws_the_same(0.1)

    def test_light_that_depends_on_the_fragment_stays_out(self):
        random_mesh(self.folder / "mesh.ply", 40, "smooth")
        scene = self.export(PERSPECTIVE, [{"mesh": "mesh.ply"}], lighting="headlight")
        self.assertFalse(scene["objects"][0]["lit"])
        self.assert_draws_the_same()

    def test_ribbons_and_discs_are_lit_as_what_they_stand_for(self):
        line = numpy.stack([numpy.linspace(-1, 1, 30), numpy.sin(numpy.linspace(0, 9, 30)), numpy.cos(numpy.linspace(0, 7, 30))], 1)
        write_ply(self.folder / "lines.ply", numpy.concatenate([line, colors(30)], 1), NAMES, edges=[(i, i + 1) for i in range(29)])
        write_ply(self.folder / "points.ply", numpy.concatenate([RANDOM.uniform(-1, 1, (20, 3)), colors(20)], 1), NAMES)
        for lighting in "headlight", "phong":
            for camera in PERSPECTIVE, ORTHOGRAPHIC:
                scene = self.export(camera, [{"lines": "lines.ply", "radius": 0.1}, {"points": "points.ply", "radius": 0.2}],
                                    lighting=lighting)
                self.assertEqual([thing["lit"] for thing in scene["objects"]], [False, False])
                self.assert_draws_the_same(0.1)

    def test_light_that_is_the_same_all_over_is_in_the_colours(self):
        random_mesh(self.folder / "mesh.ply", 40, "flat")
        for lighting in "headlight", "phong":
            scene = self.export(ORTHOGRAPHIC, [{"mesh": "mesh.ply", "color": [0.3, 0.5, 0.2]}], lighting=lighting)
            self.assertTrue(scene["objects"][0]["lit"])
            self.assert_draws_the_same()

    def test_matrices_lead_to_the_pixels(self):
        """A vertex at a pixel's centre: what OpenGL makes of it by the matrices is that pixel."""
        random_mesh(self.folder / "mesh.ply", 10)
        for camera in PERSPECTIVE, ORTHOGRAPHIC:
            scene = self.export(camera, [{"mesh": "mesh.ply"}])
            view = independent.View(scene)
            points = independent.columns(independent.read_ply(self.folder / "out/object-0.ply")["vertex"], "x", "y", "z")
            clip = numpy.append(points, numpy.ones((len(points), 1)), 1) @ (
                numpy.array(scene["camera"]["projection"]) @ numpy.array(scene["camera"]["view"])).T
            ndc = clip[:, :3] / clip[:, 3:]
            seen = view.of_world(points)
            at = seen[:, :2] / (seen[:, 2:] if view.perspective else 1) / view.pixel / [view.width / 2, view.height / 2]
            numpy.testing.assert_allclose(ndc[:, :2], at, atol=1e-12)
            inside = abs(ndc[:, :2]).max(1) < 1
            self.assertTrue((abs(ndc[inside, 2]) < 1).all())

    def test_gltf_holds_the_same(self):
        random_mesh(self.folder / "mesh.ply", 7)
        write_ply(self.folder / "lines.ply", numpy.concatenate([RANDOM.random((6, 3)), colors(6)], 1), NAMES,
                  edges=[(0, 1), (1, 2), (3, 4), (4, 5)])
        write_ply(self.folder / "points.ply", numpy.concatenate([RANDOM.random((5, 3)), colors(5), RANDOM.random((5, 1))], 1),
                  [*NAMES, "thickness"])
        scene = self.export(PERSPECTIVE, [{"mesh": "mesh.ply"}, {"lines": "lines.ply", "radius": 0.05},
                                          {"points": "points.ply", "radius": {"by": "thickness"}, "opaque": True}])
        file = (self.folder / "out/scene.glb").read_bytes()
        magic, version, length, size = struct.unpack_from("<4sIII", file)
        self.assertEqual((magic, version, length), (b"glTF", 2, len(file)))
        gltf, data = json.loads(file[20:20 + size]), file[28 + size:]

        def accessor(index):
            a = gltf["accessors"][index]
            at = gltf["bufferViews"][a["bufferView"]]
            width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
            kind = {5126: "<f4", 5125: "<u4"}[a["componentType"]]
            return numpy.frombuffer(data, kind, a["count"] * width, at.get("byteOffset", 0)).reshape(-1, width)

        for mesh, thing, mode in zip(gltf["meshes"], scene["objects"], (4, 1, 0)):
            ply = independent.read_ply(self.folder / "out" / thing["file"])
            (part,) = mesh["primitives"]
            self.assertEqual(part.get("mode", 4), mode)
            self.assertEqual(gltf["materials"][part["material"]].get("alphaMode", "OPAQUE"), "OPAQUE" if thing["opaque"] else "BLEND")
            numpy.testing.assert_array_equal(accessor(part["attributes"]["POSITION"]), independent.columns(ply["vertex"], "x", "y", "z"))
            numpy.testing.assert_array_equal(accessor(part["attributes"]["COLOR_0"]),
                                             independent.columns(ply["vertex"], "red", "green", "blue", "alpha"))
            if mode == 0:
                numpy.testing.assert_array_equal(accessor(part["attributes"]["_RADIUS"])[:, 0], ply["vertex"]["radius"])
            self.assertEqual(mesh.get("extras", {}).get("radius"), thing["radius"])
            if mode == 4:
                numpy.testing.assert_array_equal(accessor(part["indices"]).reshape(-1, 3), ply["face"]["corners"])
            if mode == 1:
                edges = numpy.stack([ply["edge"]["vertex1"], ply["edge"]["vertex2"]], -1)
                numpy.testing.assert_array_equal(edges, [(0, 1), (1, 2), (3, 4), (4, 5)])
                numpy.testing.assert_array_equal(ply["vertex"]["line"], [0, 0, 0, 1, 1, 1])
                numpy.testing.assert_array_equal(accessor(part["indices"]).reshape(-1, 2), edges)
        camera = gltf["cameras"][0]["perspective"]
        self.assertAlmostEqual(camera["yfov"], numpy.radians(40))
        self.assertAlmostEqual(camera["aspectRatio"], 61 / 47)
        matrix = numpy.array(next(node["matrix"] for node in gltf["nodes"] if "camera" in node)).reshape(4, 4).T
        numpy.testing.assert_allclose(matrix @ numpy.array(scene["camera"]["view"]), numpy.eye(4), atol=1e-14)

    def test_what_floats_do_not_hold_is_refused_or_told(self):
        for scale, code in (1e30, 0), (1e39, 2), (1e200, 2), (1e-200, 0):
            corners = [[-scale, -scale, 0], [scale, -scale, 0], [0, scale, 0.3 * scale]]
            (self.folder / "mesh.ply").write_text("\n".join(
                ["ply", "format ascii 1.0", "element vertex 3", *(f"property double {axis}" for axis in "xyz"), "element face 1",
                 "property list uchar int vertex_indices", "end_header", *(" ".join(map(repr, x)) for x in corners), "3 0 1 2", ""]))
            (self.folder / "scene.json").write_text(json.dumps(
                {"format": "pellucid-scene", "version": 1, "resolution": [8, 8], "objects": [{"mesh": "mesh.ply"}]}))
            out = self.folder / f"out{scale}"
            done = subprocess.run([os.environ["PELLUCID_PROGRAM"], "export", self.folder / "scene.json", "-o", out, "--quiet"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(out.exists(), code == 0)
            if code == 0:
                self.assertGreater(json.loads((out / "scene.json").read_text())["rounding"], 0)

    def test_vtk_reads_the_gltf(self):
        try:
            from vtkmodules.util.numpy_support import vtk_to_numpy
            from vtkmodules.vtkIOGeometry import vtkGLTFReader
        except ImportError:
            self.skipTest("no python3-vtk9")
        random_mesh(self.folder / "mesh.ply", 9)
        self.export(PERSPECTIVE, [{"mesh": "mesh.ply"}])
        reader = vtkGLTFReader()
        reader.SetFileName(str(self.folder / "out/scene.glb"))
        reader.Update()
        found = reader.GetOutput().NewIterator()
        mesh = found.GetCurrentDataObject()
        ply = independent.read_ply(self.folder / "out/object-0.ply")
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()), (27, 9))
        numpy.testing.assert_array_equal(vtk_to_numpy(mesh.GetPointData().GetArray("COLOR_0")),
                                         independent.columns(ply["vertex"], "red", "green", "blue", "alpha"))


if __name__ == "__main__":
    unittest.main()
