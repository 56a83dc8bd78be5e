#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds what the program reads of files in Debian's packages, and of files that other programs write here, to what
independent readers make of them: counts, bounds, ranges, values in the middle of cells; of meshes their area, where it
is and its colours. PELLUCID_PROGRAM is the program, PELLUCID_DEBIAN_DATA the folder that the packages were unpacked in
(dpkg -x); assimp, plastimatch, plot3d_to_cgns and OpenFOAM's programs are looked for on the PATH. Exits with 77, which
CTest takes for skipped, where a file, a writer or a reader of any row is missing, after the others are compared."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
from typing import NamedTuple

try:
    import numpy as np
    import other_readers
    import other_writers
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

PROGRAM = os.environ.get("PELLUCID_PROGRAM", "build/release/pellucid")
OWN_SCALARS = {"speed", "t", "time"}  # of what is integrated
failures = []


class File(NamedTuple):
    """A package's file, its reader in other_readers.py, and further arguments of that."""
    package: str
    path: str
    reader: str
    arguments: tuple = ()


ASSIMP, MAYAVI = "usr/share/assimp/models/", "usr/lib/python3/dist-packages/mayavi/tests/data/"
MAYAVI_EXAMPLES = "usr/share/doc/mayavi2/examples/mayavi/data/"
NIBABEL, NCARG = "usr/lib/python3/dist-packages/nibabel/tests/data/", "usr/share/ncarg/data/"
SFEPY, FOAM = "usr/lib/python3/dist-packages/sfepy/meshes/", "usr/share/doc/openfoam-examples/examples/"

FILES = [
    *(File("assimp-testmodels", ASSIMP + name, "assimp") for name in (
        "OBJ/WusonOBJ.obj", "OBJ/concave_polygon.obj", "OBJ/cube_with_vertexcolors.obj", "OBJ/spider.obj",
        "OFF/Wuson.off", "OFF/Cube.off", "PLY/cube_binary.ply", "PLY/cube_uv.ply", "PLY/float-color.ply",
        "STL/Wuson.stl", "STL/Spider_ascii.stl", "STL/Spider_binary.stl", "STL/3DSMaxExport.STL",
        "STL/sphereWithHole.stl", "glTF2/ClearCoat-glTF/ClearCoatTest.gltf",
        "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
        "glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_12.gltf")),
    File("mayavi2", MAYAVI + "pyramid.ply", "assimp"),
    File("mayavi2", MAYAVI + "shuttle.obj", "assimp"),
    File("netgen-doc", "usr/share/doc/netgen/examples/hinge.stl", "assimp"),
    File("openfoam-examples", FOAM + "mesh/snappyHexMesh/gap_detection/constant/triSurface/mech_test.obj", "assimp"),
    File("assimp-testmodels", ASSIMP + "PLY/points.ply", "ply_points"),
    File("assimp-testmodels", ASSIMP + "OBJ/testline.obj", "obj_lines"),
    File("openfoam-examples", FOAM + "mesh/blockMesh/pipe/constant/geometry/curve.obj", "obj_lines"),
    *(File("mayavi2", MAYAVI + name, "vtk_file") for name in (
        "RectGrid2.vtk", "SampleStructGrid.vtk", "cube.vti", "polyEx.vtk", "uGridEx.vtk")),
    *(File("mayavi2", MAYAVI_EXAMPLES + name, "vtk_file") for name in ("heart.vtk", "heart.vti")),
    File("mayavi2", MAYAVI_EXAMPLES + "fire_ug.vtu", "meshio_file"),
    File("mayavi2", MAYAVI + "pyramid_ug.vtu", "meshio_file"),
    *(File("python3-sfepy", SFEPY + name, "meshio_file") for name in (
        "3d/cylinder.vtk", "3d/acoustic_wg.vtk", "3d/piezo_mesh_micro.vtk", "2d/special/circles_in_square.vtk")),
    File("mayavi2", MAYAVI + "disk_out_ref.ex2", "exodus"),
    File("mayavi2", MAYAVI + "tiny.xyz", "plot3d"),
    *(File("ferret-datasets", "usr/share/ferret-vis/data/" + name, "netcdf", arrays) for name, *arrays in (
        ("coads_climatology.cdf", "SST", "UWND"), ("levitus_climatology.cdf", "TEMP"), ("etopo60.cdf", "ROSE"),
        ("monthly_navy_winds.cdf", "UWND", "VWND"), ("ocean_atlas_subset.nc", "TEMP"))),
    *(File("libncarg-data", NCARG + name, "netcdf", arrays) for name, *arrays in (
        ("cdf/uv300.nc", "U", "V"), ("cdf/meccatemp.cdf", "t"),
        ("nug/rectilinear_grid_3D.nc", "t", "rhumidity"), ("nug/uas_rectilinear_grid_2D.nc", "uas"))),
    File("libncarg-data", NCARG + "cdf/pop.nc", "netcdf_curved", ("lon2d", "lat2d", "urot", "vrot")),
    *(File("python3-nibabel", NIBABEL + name, "nifti") for name in (
        "anatomical.nii", "standard.nii.gz", "reoriented_anat_moved.nii", "resampled_anat_moved.nii")),
    *(File("python3-dipy", "usr/lib/python3/dist-packages/dipy/data/files/" + name, "nifti") for name in (
        "S0_10slices.nii.gz", "aniso_vox.nii.gz")),
    File("mricron-data", "usr/share/mricron/templates/inia19-t1-brain.nii.gz", "nifti"),
    *(File("python3-nibabel", NIBABEL + name, "tracks") for name in (
        "standard.tck", "simple_big_endian.tck", "multiline_header_field.tck", "standard.trk", "standard.LPS.trk",
        "complex_big_endian.trk")),
    File("insighttoolkit5-examples",
         "usr/share/doc/insighttoolkit5-examples/examples/Data/BrainProtonDensity3Slices.mha", "meta_image"),
]


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, encoding="utf-8", check=False)


def info(path):
    told = run("info", path, "--json", "--quiet")
    if told.returncode != 0:
        raise ValueError(told.stderr.strip())
    return json.loads(told.stdout)


def largest_difference(got, wanted, size):
    """As a share of `size`; infinite where there are not as many numbers."""
    got, wanted = np.asarray(got, float).ravel(), np.asarray(wanted, float).ravel()
    return np.inf if got.shape != wanted.shape else np.abs(got - wanted).max(initial=0) / (size or 1)


def expect(name, got, wanted, tolerance=0.0, size=1.0):
    off = largest_difference(got, wanted, size)
    if not off <= tolerance:
        failures.append(name)
        print(f"FAIL {name}: {np.asarray(got).ravel()[:6]}; the other reader: {np.asarray(wanted).ravel()[:6]}")
    return off <= tolerance


# --- Meshes -----------------------------------------------------------------------------------


def drawn(path, folder):
    """The triangles that the program draws, each of three corners, with their colours."""
    scene, out = folder / "scene.json", folder / "exported"
    scene.write_text(json.dumps({"format": "pellucid-scene", "version": 1, "resolution": [8, 8],
                                 "objects": [{"mesh": str(path)}]}))
    shutil.rmtree(out, ignore_errors=True)
    done = run("export", scene, "-o", out, "--quiet")
    if done.returncode != 0:
        raise ValueError(done.stderr.strip())
    return other_readers.ply_triangles(out / "object-0.ply")


def moments(corners, weights):
    """Area, its vector, and the integrals of position and `weights` (colours), whatever the order of the triangles."""
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    areas = np.linalg.norm(vectors, axis=1)
    return [areas.sum(), *vectors.sum(axis=0), *(areas @ corners.mean(axis=1)), *(areas @ weights.mean(axis=1))]


def compare_mesh(name, path, other, folder):
    corners, colors = drawn(path, folder)
    wanted_corners, wanted_colors = other
    if wanted_colors is None:
        colors, wanted_colors = np.zeros_like(corners), np.zeros_like(wanted_corners)
    size = np.abs(wanted_corners).max()
    # Both are of floats; colours of the other reader are bytes.
    fine = expect(f"{name}: bounds", [corners.min((0, 1)), corners.max((0, 1))],
                  [wanted_corners.min((0, 1)), wanted_corners.max((0, 1))], 1e-6, size)
    areas = moments(corners, colors[..., :3]), moments(wanted_corners, wanted_colors[..., :3])
    scale = areas[1][0] * np.array([1, 1, 1, 1, size, size, size, 1, 1, 1])
    return expect(f"{name}: area, place, colours", areas[0] / scale, areas[1] / scale, 1 / 255 / 2) and fine and \
        expect(f"{name}: area, place", areas[0][:7] / scale[:7], areas[1][:7] / scale[:7], 2e-6)


# --- Points, lines, samples -------------------------------------------------------------------


def array_of(told, name):
    found = [array for array in told["arrays"] if array["name"] == name]
    return found[0] if found else {"ranges": [], "not_finite": -1}


def compare_arrays(name, told, data):
    fine = True
    for key, values in data.items():
        columns = np.asarray(values, float).reshape(len(values), -1)
        ranges = [[np.nanmin(column), np.nanmax(column)] for column in columns.T]
        fine &= expect(f"{name}: {key}", array_of(told, key)["ranges"], ranges, 1e-6, np.abs(ranges).max())
        fine &= expect(f"{name}: {key}, absent", array_of(told, key)["not_finite"], np.isnan(columns).any(axis=1).sum())
    return fine


def values_at(path, key, places, is_vector, duration, choice, folder):
    """What the program interpolates: it starts a line at each place, a vector's length or a scalar."""
    seeds, lines = folder / "seeds.csv", folder / "lines.ply"
    seeds.write_text("x,y,z\n" + "".join(",".join(map(repr, map(float, place))) + "\n" for place in places))
    array = f"array={key}" if is_vector else f"array={key},0,0"
    column = "speed" if is_vector else f"point:{key}" if key in OWN_SCALARS else key
    carry = [] if is_vector else ["--carry", column]
    done = run("trace", "--field", f"{path}:{array},{choice}", "--integrator", "stream-lines", "--seeds", seeds,
               "--duration", duration, "-o", lines, "--quiet", *carry)
    if done.returncode != 0:
        raise ValueError(done.stderr.strip())
    vertices = other_readers.ply_vertices(lines)
    return vertices[column][vertices["t"] == 0]


def compare_samples(name, path, other, folder):
    """Means over corners, where the mean of their places is: exact for all of VTK's linear cells."""
    fine, random = True, np.random.default_rng(5)
    for key, means in other.means.items():
        is_vector = means.ndim == 2
        wanted = np.linalg.norm(means, axis=1) if is_vector else means
        some = random.permutation(np.flatnonzero(np.isfinite(wanted) & (wanted != 0)))[:6]
        if len(some) > 0:
            largest = np.abs(wanted[some]).max()
            duration = 1e-6 * np.ptp(other.points, axis=0).max() / largest
            got = values_at(path, key, other.centres[some], is_vector, duration, other.choice, folder)
            fine &= expect(f"{name}: {key} within", got, wanted[some], 1e-5, largest)
    return fine


def compare_data(name, path, other, folder):
    told = info(path)
    box = [told["bounds"]["min"], told["bounds"]["max"]]
    fine = expect(f"{name}: counts", [told["counts"][key] for key in other.counts], list(other.counts.values()))
    fine &= expect(f"{name}: bounds", box, [other.points.min(axis=0), other.points.max(axis=0)], 1e-6,
                   np.abs(other.points).max())
    return compare_arrays(name, told, other.data) and compare_samples(name, path, other, folder) and fine


def compare(name, path, other, folder):
    try:
        compare_one = compare_data if isinstance(other, other_readers.Samples) else compare_mesh
        if compare_one(name, path, other, folder):
            print(f"ok   {name}")
    except (ValueError, KeyError) as problem:
        failures.append(name)
        print(f"FAIL {name}: {problem}")


def load(data, file):
    path = data / file.path
    if not path.exists():
        raise FileNotFoundError("not unpacked")
    return path, getattr(other_readers, file.reader)(path, *file.arguments)


def attempt(name, get, folder):
    """Says whether the file, its writer and the other reader are there; `get` returns the file and what it holds."""
    try:
        path, other = get()
    except (ImportError, FileNotFoundError) as missing:
        print(f"skip {name}: {missing}")
        return False
    except subprocess.CalledProcessError as problem:
        failures.append(name)
        print(f"FAIL {name}: {problem}")
        return True
    compare(name, path, other, folder)
    return True


def attempt_all(data, folder):
    kept = [attempt(f"{file.package}: {pathlib.Path(file.path).name}, {file.reader}", lambda: load(data, file), folder)
            for file in FILES]
    written = [attempt(f"written here: {write.__name__}", lambda: write(data, folder), folder)
               for write in other_writers.ALL]
    return all(kept + written)


def main():
    if not os.environ.get("PELLUCID_DEBIAN_DATA"):
        print("skipped: PELLUCID_DEBIAN_DATA names no folder")
        sys.exit(77)
    data = pathlib.Path(os.environ["PELLUCID_DEBIAN_DATA"])
    with tempfile.TemporaryDirectory() as folder:
        were_there = attempt_all(data, pathlib.Path(folder))
    if failures:
        sys.exit(1)
    sys.exit(0 if were_there else 77)


if __name__ == "__main__":
    main()
