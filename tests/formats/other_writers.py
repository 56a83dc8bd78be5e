# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that other programs write, each with what was written: for formats of which no package of Debian has a file."""

import os
import shlex
import shutil
import subprocess

import numpy as np
import other_readers
from other_readers import Samples

MAYAVI = "usr/lib/python3/dist-packages/mayavi/tests/data/"
SFEPY = "usr/lib/python3/dist-packages/sfepy/meshes/3d/"
BRAIN = "usr/lib/python3/dist-packages/nibabel/tests/data/anatomical.nii"
CAVITY = "usr/share/doc/openfoam-examples/examples/incompressible/icoFoam/cavity/cavity"


def call(*words, cwd=None):
    subprocess.run([str(word) for word in words], cwd=cwd, check=True, capture_output=True)


# --- meshio, plastimatch (ITK), CGNS's tools, mrcfile, OpenVDB, pandas ------------------------


def by_meshio(data, path, file_format):
    """A body of tetrahedra with three scalars."""
    import meshio
    mesh = meshio.read(data / SFEPY / "cylinder.vtk")
    x, y, z = np.asarray(mesh.points, float).T
    values = {"u": 1 + 2 * x, "v": y - 1, "w": np.sin(20 * z)}
    cells = [block for block in mesh.cells if block.type == "tetra"]
    meshio.Mesh(np.stack([x, y, z], axis=1), cells, point_data=values).write(path, file_format)
    return path, other_readers.cells_of(np.stack([x, y, z], axis=1), values, [block.data for block in cells])


def tecplot(data, folder):
    return by_meshio(data, folder / "a.tec", "tecplot")


def unstructured(data, folder):
    return by_meshio(data, folder / "meshio.vtu", "vtu")


def by_itk(data, path):
    call("plastimatch", "convert", "--input", data / BRAIN, "--output-img", path)
    return path, other_readers.nifti(data / BRAIN, "NRRD")


def nrrd(data, folder):
    return by_itk(data, folder / "a.nrrd")


def nhdr(data, folder):
    return by_itk(data, folder / "a.nhdr")


def cgns(data, folder):
    grid = data / MAYAVI / "tiny.xyz"
    call("plot3d_to_cgns", "-c", "-u", "-Mbsieee", grid, grid.with_suffix(".q"), folder / "a.cgns")
    return folder / "a.cgns", other_readers.plot3d(grid)


def mrc(_, folder):
    import mrcfile
    with mrcfile.new(folder / "a.mrc", overwrite=True) as image:
        image.set_data(np.random.default_rng(1).normal(size=(4, 5, 6)).astype(np.float32))
        image.voxel_size = (1.5, 2, 3)
        image.header.origin.x = 10
    return folder / "a.mrc", other_readers.mrc(folder / "a.mrc")


def vdb(_, folder):
    import pyopenvdb
    values = np.random.default_rng(2).normal(size=(5, 6, 7, 3)).astype(np.float32)
    grid = pyopenvdb.Vec3SGrid()
    grid.copyFromArray(values)
    grid.transform = pyopenvdb.createLinearTransform(0.5)
    grid.name = "wind"
    pyopenvdb.write(str(folder / "a.vdb"), grids=[grid])
    return folder / "a.vdb", other_readers.grid(other_readers.placed(values.shape[:3], np.diag([.5, .5, .5, 1])),
                                                {"wind": values.astype(float)})._replace(counts={})


def csv(_, folder):
    import pandas
    numbers = np.random.default_rng(3).normal(size=(50, 4))
    pandas.DataFrame(numbers, columns=["x", "y", "z", "mass"]).to_csv(folder / "a.csv", index=False)
    return folder / "a.csv", Samples(numbers[:, :3], {"points": 50}, {"mass": numbers[:, 3]})


# --- OpenFOAM ---------------------------------------------------------------------------------


def foam_numbers(path):
    """The values of an internal field in text."""
    text = path.read_text(encoding="ascii").split("internalField", 1)[1].split("(", 1)[1].split(";", 1)[0]
    rows = [line.strip("()").split() for line in text.splitlines() if line.strip("() ")]
    return np.array(rows, float).squeeze()


def cavity(data, folder):
    """OpenFOAM's lid-driven cavity at its last time, of 20 by 20 cells of one size; values hold in whole cells."""
    case = folder / "cavity"
    if not case.exists():
        shutil.copytree(data / CAVITY, case)
        call("gunzip", "-rf", case)
        for program in ("blockMesh", "icoFoam", "foamToEnsight", "foamToVTK"):
            call(program, cwd=case)
    centres = other_readers.placed((20, 20, 1), np.diag([0.005, 0.005, 0.01, 1])).transpose(2, 1, 0, 3).reshape(-1, 3)
    values = {name: foam_numbers(case / "0.5" / name) for name in ("U", "p")}
    return case, Samples(np.array([[0, 0, 0], [0.1, 0.1, 0.01]]), {}, {}, centres + (0.0025, 0.0025, 0.005), values,
                         "time=last,cells=constant")


def foam(data, folder):
    case, samples = cavity(data, folder)
    (case / "cavity.foam").touch()
    return case / "cavity.foam", samples


def ensight_of_foam(data, folder):
    case, samples = cavity(data, folder)
    return case / "EnSight/cavity.case", samples


def vtm_of_foam(data, folder):
    """Its values at points go before those of cells."""
    case, samples = cavity(data, folder)
    means = {"cell:" + name: values for name, values in samples.means.items()}
    return case / "VTK/cavity.vtm.series", samples._replace(means=means)


# --- VTK --------------------------------------------------------------------------------------


def vtk_sources():
    """A number on grids of each kind, by the letter that the kinds have in the endings of files."""
    import vtk
    image = vtk.vtkRTAnalyticSource()
    image.SetWholeExtent(-3, 4, 0, 5, 1, 5)
    points, cells = vtk.vtkImageDataToPointSet(), vtk.vtkAppendFilter()
    for algorithm in (points, cells):
        algorithm.SetInputConnection(image.GetOutputPort())
        algorithm.Update()
    axes = vtk.vtkRectilinearGrid()
    axes.SetDimensions(8, 6, 5)
    for axis, count in zip("XYZ", axes.GetDimensions()):
        numbers = vtk.vtkDoubleArray()
        for i in range(count):
            numbers.InsertNextValue(i * i + 1)
        getattr(axes, f"Set{axis}Coordinates")(numbers)
    axes.GetPointData().ShallowCopy(cells.GetOutput().GetPointData())
    producer = vtk.vtkTrivialProducer()
    producer.SetOutput(axes)
    ball, heights = vtk.vtkSphereSource(), vtk.vtkElevationFilter()
    heights.SetInputConnection(ball.GetOutputPort())
    return {"p": (heights, "PolyData"), "i": (image, "ImageData"), "r": (producer, "RectilinearGrid"),
            "s": (points, "StructuredGrid"), "u": (cells, "UnstructuredGrid")}


def by_vtk(kind, path, pieces):
    import vtk
    source, name = vtk_sources()[kind]
    source.Update()
    samples = other_readers.vtk_data(source.GetOutputDataObject(0))  # before it is asked for pieces
    writer = getattr(vtk, f"vtkXML{'P' if pieces > 1 else ''}{name}Writer")()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(str(path))
    if pieces > 1:
        writer.SetNumberOfPieces(pieces)
        writer.SetEndPiece(pieces - 1)
    writer.Write()
    return path, samples._replace(counts={}) if pieces > 1 else samples


def vtk_file(kind, pieces):
    def write(_, folder):
        return by_vtk(kind, folder / f"vtk.{'p' if pieces > 1 else ''}vt{kind}", pieces)
    write.__name__ = f"{'p' if pieces > 1 else ''}vt{kind}"
    return write


def put_block(blocks, i, block):
    """VTK has three classes of these, each with names of its own."""
    if blocks.IsA("vtkMultiBlockDataSet"):
        blocks.SetBlock(i, block)
    elif blocks.IsA("vtkPartitionedDataSet"):
        blocks.SetPartition(i, block)
    else:
        blocks.SetPartition(i, 0, block)


def many_blocks(ending, data_set, writer):
    """Two blocks, of which each has a half."""
    def write(_, folder):
        import vtk
        image, _ = vtk_sources()["i"]
        image.Update()
        whole, both = image.GetOutput(), getattr(vtk, data_set)()
        for i, half in enumerate(((-3, 0, 0, 5, 1, 5), (0, 4, 0, 5, 1, 5))):
            part = vtk.vtkExtractVOI()
            part.SetInputData(whole)
            part.SetVOI(half)
            part.Update()
            put_block(both, i, part.GetOutput())
        one = getattr(vtk, writer)()
        one.SetInputData(both)
        one.SetFileName(str(folder / f"blocks{ending}"))
        one.Write()
        return folder / f"blocks{ending}", other_readers.vtk_data(whole)._replace(counts={})
    write.__name__ = ending[1:]
    return write


def pvd(_, folder):
    """ParaView's own series, by its pvbatch, or by what PELLUCID_PVBATCH names."""
    script = folder / "series.py"
    script.write_text('''
from paraview.simple import *
places = Calculator(Input=Wavelet(WholeExtent=[-4, 4, -3, 3, 0, 2]), ResultArrayName="xyz", Function="coords")
steps = GenerateTimeSteps(Input=places, TimeStepValues=[0.0, 0.5, 2.0])
wind = PythonCalculator(Input=steps, ArrayName="wind",
                        Expression="make_vector(1 + time_value * xyz[:, 0], 2 * xyz[:, 1], time_value + 0 * xyz[:, 2])")
steps.UpdatePipeline(0.0)
SaveData("series.pvd", proxy=wind, WriteTimeSteps=1)
''')
    call(*shlex.split(os.environ.get("PELLUCID_PVBATCH", "pvbatch")), script, cwd=folder)
    points = other_readers.placed((9, 7, 3), np.eye(4)) + [-4, -3, 0]
    x, y, z = np.moveaxis(points, -1, 0)
    at_half = np.stack([1 + 0.5 * x, 2 * y, 0.5 + 0 * z], axis=-1)
    return folder / "series.pvd", other_readers.grid(points, {"wind": at_half})._replace(
        counts={"files": 3}, data={}, choice="time=0.5")


ALL = [tecplot, unstructured, nrrd, nhdr, cgns, mrc, vdb, csv, foam, ensight_of_foam, vtm_of_foam, pvd,
       *(vtk_file(kind, pieces) for kind in "pirsu" for pieces in (1, 2)),
       many_blocks(".vtm", "vtkMultiBlockDataSet", "vtkXMLMultiBlockDataWriter"),
       many_blocks(".vtpd", "vtkPartitionedDataSet", "vtkXMLPartitionedDataSetWriter"),
       many_blocks(".vtpc", "vtkPartitionedDataSetCollection", "vtkXMLPartitionedDataSetCollectionWriter")]
