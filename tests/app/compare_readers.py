#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds `pellucid info` to independent readers: VTK's Python and nibabel, on files that those
programs wrote. Exits with 77 where neither is installed."""

import math
import sys
import tempfile
from pathlib import Path

from told_by_info import SKIPPED, array_of, end, expect, failures, flat_bounds, info


# --- VTK --------------------------------------------------------------------------------------


def vtk_source(vtk):
    """A sphere with a scalar, a vector and colours at its points, and a number at its cells."""
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(1.7)
    sphere.SetCenter(0.1, -3, 12)
    sphere.SetThetaResolution(9)
    sphere.Update()
    data = sphere.GetOutput()
    for name, components, kind in (("height", 1, vtk.vtkDoubleArray), ("flow", 3, vtk.vtkFloatArray)):
        array = kind()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(data.GetNumberOfPoints())
        for i in range(data.GetNumberOfPoints()):
            for c in range(components):
                array.SetComponent(i, c, math.sin(i * 1.7 + c) / 3)
        data.GetPointData().AddArray(array)
    cells = vtk.vtkIntArray()
    cells.SetName("region")
    for i in range(data.GetNumberOfCells()):
        cells.InsertNextValue(7 * i - 100)
    data.GetCellData().AddArray(cells)
    return data


def compare_arrays(path, told, attributes, at):
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(k)
        mine = array_of(told, array.GetName())
        if mine is None or mine["at"] != at:
            failures.append(f"{path.name}: no {at} array {array.GetName()}")
            continue
        for c in range(array.GetNumberOfComponents()):
            expect(f"{path.name}: {array.GetName()}[{c}]", mine["ranges"][c], array.GetFiniteRange(c))


def compare_data_set(vtk, path, reader):
    reader.SetFileName(str(path))
    reader.Update()
    data, told = reader.GetOutput(), info(path)
    if told is None:
        return
    box = data.GetBounds()
    expect(f"{path.name}: bounds", flat_bounds(told), [box[0], box[2], box[4], box[1], box[3], box[5]])
    expect(f"{path.name}: counts", [told["counts"]["points"], told["counts"]["cells"]],
           [data.GetNumberOfPoints(), data.GetNumberOfCells()])
    compare_arrays(path, told, data.GetPointData(), "point")
    compare_arrays(path, told, data.GetCellData(), "cell")


def write_vtk(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()


def vtk_data_sets(vtk, folder):
    poly = vtk_source(vtk)
    write_vtk(vtk.vtkXMLPolyDataWriter(), poly, folder / "a.vtp")
    compare_data_set(vtk, folder / "a.vtp", vtk.vtkXMLPolyDataReader())
    write_vtk(vtk.vtkPolyDataWriter(), poly, folder / "a.vtk")
    compare_data_set(vtk, folder / "a.vtk", vtk.vtkPolyDataReader())
    cells = vtk.vtkDelaunay3D()
    cells.SetInputData(poly)
    cells.Update()
    write_vtk(vtk.vtkXMLUnstructuredGridWriter(), cells.GetOutput(), folder / "a.vtu")
    compare_data_set(vtk, folder / "a.vtu", vtk.vtkXMLUnstructuredGridReader())
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-3, 4, 0, 5, 1, 3)
    wavelet.Update()
    write_vtk(vtk.vtkXMLImageDataWriter(), wavelet.GetOutput(), folder / "a.vti")
    compare_data_set(vtk, folder / "a.vti", vtk.vtkXMLImageDataReader())


def compare_mesh(path, reader):
    """Formats that hold triangles and nothing at cells."""
    reader.SetFileName(str(path))
    reader.Update()
    data, told = reader.GetOutput(), info(path)
    if told is None:
        return
    box = data.GetBounds()
    expect(f"{path.name}: bounds", flat_bounds(told), [box[0], box[2], box[4], box[1], box[3], box[5]], 1e-7)
    expect(f"{path.name}: counts", [told["counts"]["points"], told["counts"]["triangles"]],
           [data.GetNumberOfPoints(), data.GetNumberOfPolys()])


def vtk_meshes(vtk, folder):
    poly = vtk_source(vtk)
    write_vtk(vtk.vtkPLYWriter(), poly, folder / "a.ply")
    compare_mesh(folder / "a.ply", vtk.vtkPLYReader())
    write_vtk(vtk.vtkOBJWriter(), poly, folder / "a.obj")
    compare_mesh(folder / "a.obj", vtk.vtkOBJReader())


def gltf(vtk, folder):
    """A file of vtkGLTFExporter's, read by vtkGLTFReader."""
    mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
    mapper.SetInputData(vtk_source(vtk))
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    renderer.AddActor(actor)
    window.AddRenderer(renderer)
    exporter = vtk.vtkGLTFExporter()
    exporter.SetFileName(str(folder / "a.gltf"))
    exporter.SetRenderWindow(window)
    exporter.InlineDataOn()
    exporter.Write()
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(str(folder / "a.gltf"))
    reader.Update()
    told = info(folder / "a.gltf")
    if told is None:
        return
    flat = vtk.vtkCompositeDataGeometryFilter()
    flat.SetInputConnection(reader.GetOutputPort())
    flat.Update()
    box = flat.GetOutput().GetBounds()
    expect("a.gltf: bounds", flat_bounds(told), [box[0], box[2], box[4], box[1], box[3], box[5]], 1e-6)
    expect("a.gltf: triangles", [told["counts"]["triangles"]], [flat.GetOutput().GetNumberOfPolys()])


def compare_with_vtk(folder):
    try:
        import vtk
    except ImportError:
        return False
    vtk_data_sets(vtk, folder)
    vtk_meshes(vtk, folder)
    gltf(vtk, folder)
    return True


# --- nibabel ----------------------------------------------------------------------------------


def compare_tracks(path, load):
    import numpy
    tracks = [numpy.asarray(t, dtype=float) for t in load(str(path)).streamlines]
    told = info(path)
    if told is None:
        return
    points = numpy.concatenate(tracks)
    expect(f"{path.name}: counts", [told["counts"]["points"], told["counts"]["lines"]], [len(points), len(tracks)])
    # nibabel turns the points by float matrices; coordinates are up to some hundreds.
    expect(f"{path.name}: bounds", flat_bounds(told), [*points.min(axis=0), *points.max(axis=0)], 1e-5)


def compare_values(path, load):
    """What the points and the tracks carry."""
    import numpy
    tractogram = load(str(path)).tractogram
    told = info(path)
    for values in (tractogram.data_per_point, tractogram.data_per_streamline):
        for name in values:
            numbers = numpy.concatenate([numpy.atleast_2d(v) for v in values[name]])
            for c in range(numbers.shape[1]):
                mine = array_of(told, name if numbers.shape[1] == 1 else f"{name}_{c}")
                if mine is None:
                    failures.append(f"{path.name}: no array {name}")
                    continue
                expect(f"{path.name}: {name}[{c}]", mine["ranges"][0],
                       [numbers[:, c].min(), numbers[:, c].max()], 1e-6)


def compare_image(path, matrix, nibabel):
    """Where the corners are, and the numbers: an image by its qform and its sform, and by one of the two."""
    import numpy
    values = numpy.arange(60, dtype=numpy.int16).reshape(3, 4, 5)
    for codes in ((1, 1), (1, 0), (0, 1)):
        image = nibabel.Nifti1Image(values, matrix)
        for put, code in zip((image.set_qform, image.set_sform), codes):
            put(matrix if code else None, code)
        image.header.set_slope_inter(0.5, -3)
        nibabel.save(image, path)
        image, told = nibabel.load(path), info(path)
        if told is None:
            return
        corners = numpy.array([[i, j, k] for i in (0, 2) for j in (0, 3) for k in (0, 4)])
        places = corners @ image.affine[:3, :3].T + image.affine[:3, 3]
        # Quaternions are floats, and coordinates up to some tens.
        expect(f"{path.name}: bounds by {codes}", flat_bounds(told), [*places.min(axis=0), *places.max(axis=0)], 1e-5)
        numbers = image.get_fdata()
        expect(f"{path.name}: values", array_of(told, "NIFTI")["ranges"][0], [numbers.min(), numbers.max()], 1e-6)


def compare_images(folder, nibabel):
    """Along the axes of the scanner, some of them turned round; permuted; oblique, right- and left-handed."""
    import numpy
    turn = numpy.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]) @ numpy.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
    steps = {"ras": numpy.diag([2, 1.5, 1]), "las": numpy.diag([-2, 1.5, 1]), "lpi": numpy.diag([-2, -1.5, -1]),
             "asr": numpy.array([[0, 0, 2], [1, 0, 0], [0, 1.5, 0]]),
             "oblique": turn @ numpy.diag([2, 1.5, 1]), "oblique_left": turn @ numpy.diag([2, -1.5, 1])}
    for name, step in steps.items():
        matrix = numpy.eye(4)
        matrix[:3, :3], matrix[:3, 3] = step, [10, -20, 30]
        compare_image(folder / f"{name}.nii", matrix, nibabel)


def write_turned_tracks(folder):
    """Tracks in images whose axes are exchanged, turned round and sheared, in orders of other axes."""
    import numpy
    from nibabel.streamlines import Field, Tractogram, TrkFile
    points = [numpy.array([[10, 20, 30], [11, 22, 33]], "f4")]
    matrices = {"asr": [[0, 0, 2, -9], [1, 0, 0, 4], [0, 1.5, 0, 7]],
                "lip": [[-1, 0, 0, 3], [0, 0, -2, 5], [0, -1.5, 0, 8]],
                "sheared": [[1, 1.2, 0.9, 0], [-0.9, 1.1, 0.2, 0], [0.3, 0, -2, 0]]}
    for name, rows in matrices.items():
        for order in ("RAS", "SLA", "PIL"):
            path = folder / f"{name}_{order}.trk"
            header = {Field.VOXEL_TO_RASMM: numpy.array(rows + [[0, 0, 0, 1]]), Field.VOXEL_SIZES: (1, 1.5, 2),
                      Field.DIMENSIONS: (50, 60, 70), Field.VOXEL_ORDER: order}
            TrkFile(Tractogram(points, affine_to_rasmm=numpy.eye(4)), header).save(str(path))
            yield path


def compare_with_nibabel(folder):
    try:
        import nibabel
    except ImportError:
        return False
    data = Path(nibabel.__file__).parent / "tests" / "data"
    load = nibabel.streamlines.load
    for name in ("simple.tck", "simple_big_endian.tck", "standard.tck", "simple.trk", "standard.trk", "complex.trk",
                 "complex_big_endian.trk", "standard.LPS.trk"):
        compare_tracks(data / name, load)
    for name in ("complex.trk", "complex_big_endian.trk"):
        compare_values(data / name, load)
    compare_images(folder, nibabel)
    for path in write_turned_tracks(folder):
        compare_tracks(path, load)
    return True


def main():
    with tempfile.TemporaryDirectory() as folder:
        ran = [compare(Path(folder)) for compare in (compare_with_vtk, compare_with_nibabel)]
    sys.exit(end() if any(ran) else SKIPPED)


main()
