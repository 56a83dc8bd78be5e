# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the flow (-y, x, 0.1) in the formats of other programs: by VTK's and SciPy's writers where there are
some, as text otherwise. Box: x, y from -2 to 2, z from -1 to 1."""

import pathlib

import numpy as np
import vtk
from scipy.io import netcdf_file
from vtk.util.numpy_support import numpy_to_vtk

# That of several processes takes its place in VTK 9.6, and falls over where there is one.
vtk.vtkObjectFactory.SetAllEnableFlags(0, "vtkExodusIIWriter")

AXES = [np.linspace(-2, 2, 9), np.linspace(-2, 2, 9), np.linspace(-1, 1, 5)]
COUNT = [len(axis) for axis in AXES]


def crossings():
    """All points, x fastest."""
    z, y, x = np.meshgrid(AXES[2], AXES[1], AXES[0], indexing="ij")
    return np.stack([x, y, z], axis=-1).reshape(-1, 3)


def flow(points, factor=1):
    return factor * np.stack([-points[:, 1], points[:, 0], np.full(len(points), 0.1)], axis=-1)


def number(i, j, k):
    return i + COUNT[0] * (j + COUNT[1] * k)


def hexahedra():
    for k in range(COUNT[2] - 1):
        for j in range(COUNT[1] - 1):
            for i in range(COUNT[0] - 1):
                low = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                yield low + [corner + COUNT[0] * COUNT[1] for corner in low]


def vtk_array(values, name):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    return array


def unstructured():
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetData(vtk_array(crossings(), "points"))
    grid.SetPoints(points)
    for corners in hexahedra():
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, corners)
    grid.GetPointData().AddArray(vtk_array(flow(crossings()), "U"))
    return grid


def written_exodus(grid, path):
    writer = vtk.vtkExodusIIWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(path))
    writer.WriteAllTimeStepsOff()
    writer.Write()
    return path.name


def write_exodus(folder):
    return written_exodus(unstructured(), folder / "e.ex2")


def renamed_exodus(folder, name, file):
    """VTK's writer leaves out vectors whose name begins with "dis"."""
    renamed = netcdf_file(folder / file, "a")
    names = renamed.variables["name_nod_var"]
    for k, axis in enumerate("XYZ"):
        names[k] = np.frombuffer(f"{name}{axis}".encode().ljust(names.shape[1], b"\0"), "S1")
    renamed.close()
    return file


def write_exodus_moved(folder):
    """The flow is the nodes' displacement, too: they are where it has come to."""
    grid = unstructured()
    points = vtk.vtkPoints()
    points.SetData(vtk_array(crossings() - flow(crossings()), "points"))
    grid.SetPoints(points)
    return renamed_exodus(folder, "DISPL", written_exodus(grid, folder / "moved.ex2"))


def write_exodus_unmoved(folder):
    """A name that begins as that of a displacement does."""
    return renamed_exodus(folder, "dissipation", written_exodus(unstructured(), folder / "unmoved.ex2"))


def write_netcdf(folder):
    file = netcdf_file(folder / "n.nc", "w")
    for name, axis in zip("xyz", AXES):
        file.createDimension(name, len(axis))
        file.createVariable(name, "d", (name,))[:] = axis
    velocity = flow(crossings())
    for k, name in enumerate("uvw"):
        file.createVariable(name, "d", ("z", "y", "x"))[:] = velocity[:, k].reshape(COUNT[::-1])
    file.close()
    return "n.nc:array=u,v,w"


def write_netcdf_turned(folder):
    """Dimensions x, z, y, which their attributes name, z counting downwards; and a variable of two of them."""
    file = netcdf_file(folder / "turned.nc", "w")
    for name, axis in zip("xyz", AXES):
        file.createDimension(f"n{name}", len(axis))
        coordinate = file.createVariable(f"n{name}", "d", (f"n{name}",))
        coordinate[:] = -axis if name == "z" else axis
        coordinate.axis = name.upper()
        if name == "z":
            coordinate.positive = "down"
    velocity = flow(crossings())
    for k, name in enumerate("uvw"):
        values = velocity[:, k].reshape(COUNT[::-1])
        file.createVariable(name, "d", ("nx", "nz", "ny"))[:] = values.transpose(2, 0, 1)
    file.createVariable("ground", "d", ("nx", "ny"))[:] = 0
    file.close()
    return "turned.nc:array=u,v,w"


def write_netcdf_times(folder):
    """The velocity at t = 2 is three times that at t = 0."""
    file = netcdf_file(folder / "t.nc", "w")
    file.createDimension("time", 2)
    time = file.createVariable("time", "d", ("time",))
    time[:] = [0, 2]
    time.units = "seconds since 2000-01-01"
    for name, axis in zip("xyz", AXES):
        file.createDimension(name, len(axis))
        file.createVariable(name, "d", (name,))[:] = axis
    for k, name in enumerate("uvw"):
        variable = file.createVariable(name, "d", ("time", "z", "y", "x"))
        for step in range(2):
            variable[step] = flow(crossings(), 1 + 2 * step)[:, k].reshape(COUNT[::-1])
    file.close()
    return "t.nc:array=u,v,w"


def write_nifti(folder):
    image = vtk.vtkImageData()
    image.SetDimensions(COUNT)
    image.SetSpacing([axis[1] - axis[0] for axis in AXES])
    image.GetPointData().SetScalars(vtk_array(flow(crossings()), "U"))
    writer = vtk.vtkNIFTIImageWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(folder / "i.nii.gz"))
    writer.Write()
    return "i.nii.gz"


def write_tecplot(folder):
    points = np.hstack([crossings(), flow(crossings())])
    lines = "\n".join(" ".join(repr(float(v)) for v in row) for row in points)
    (folder / "t.tec").write_text(
        'TITLE = "flow"\nVARIABLES = "X" "Y" "Z" "U" "V" "W"\n'
        f'ZONE T="z", I={COUNT[0]}, J={COUNT[1]}, K={COUNT[2]}, F=POINT\n{lines}\n')
    return "t.tec:array=U,V,W"


def write_plot3d(folder):
    """Density 1.25 everywhere: the velocity is not the momentum."""
    def column(values):
        return "\n".join(repr(float(v)) for v in values)
    points, velocity = crossings(), flow(crossings())
    size = " ".join(str(n) for n in COUNT)
    (folder / "p.xyz").write_text(f"{size}\n" + "\n".join(column(points[:, k]) for k in range(3)) + "\n")
    density = np.full(len(points), 1.25)
    rows = [density, *(density * velocity.T), 8 * density]
    (folder / "p.q").write_text(f"{size}\n0.5 0 1 0\n" + "\n".join(column(row) for row in rows) + "\n")
    return "p.xyz"


FOAM_HEAD = "FoamFile\n{{\n version 2.0;\n format ascii;\n class {};\n object {};\n}}\n"


def foam_list(rows):
    return f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n"


def foam_faces():
    """Faces with their owner and neighbour, inner ones first and in the order of both."""
    sides = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2)]
    seen = {}
    for cell, corners in enumerate(hexahedra()):
        for side in sides:
            face = [corners[c] for c in side]
            seen.setdefault(tuple(sorted(face)), []).append((cell, face))
    inner = sorted((pair for pair in seen.values() if len(pair) == 2), key=lambda p: (p[0][0], p[1][0]))
    outer = sorted((pair for pair in seen.values() if len(pair) == 1), key=lambda p: p[0][0])
    return inner, outer


def write_foam(folder):
    """Cell data, at two times: at t = 1 the velocity is twice that at t = 0."""
    case = folder / "case"
    mesh = case / "constant" / "polyMesh"
    mesh.mkdir(parents=True)
    inner, outer = foam_faces()
    points = ["({!r} {!r} {!r})".format(*map(float, x)) for x in crossings()]
    faces = ["4({} {} {} {})".format(*pair[0][1]) for pair in inner + outer]
    (mesh / "points").write_text(FOAM_HEAD.format("vectorField", "points") + foam_list(points))
    (mesh / "faces").write_text(FOAM_HEAD.format("faceList", "faces") + foam_list(faces))
    (mesh / "owner").write_text(FOAM_HEAD.format("labelList", "owner") +
                                foam_list([str(pair[0][0]) for pair in inner + outer]))
    (mesh / "neighbour").write_text(FOAM_HEAD.format("labelList", "neighbour") +
                                    foam_list([str(pair[1][0]) for pair in inner]))
    (mesh / "boundary").write_text(
        FOAM_HEAD.format("polyBoundaryMesh", "boundary") +
        f"1\n(\nwalls\n{{\n type wall;\n nFaces {len(outer)};\n startFace {len(inner)};\n}}\n)\n")
    centres = np.array([crossings()[corners].mean(axis=0) for corners in hexahedra()])
    for time in (0, 1):
        (case / str(time)).mkdir()
        values = ["({!r} {!r} {!r})".format(*map(float, v)) for v in flow(centres, 1 + time)]
        (case / str(time) / "U").write_text(
            FOAM_HEAD.format("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\n"
            "internalField nonuniform List<vector>\n" + foam_list(values) +
            ";\nboundaryField\n{\n walls\n {\n type zeroGradient;\n }\n}\n")
    (case / "system").mkdir()
    (case / "system" / "controlDict").write_text(
        FOAM_HEAD.format("dictionary", "controlDict") +
        "startFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 1;\ndeltaT 1;\n"
        "writeControl timeStep;\nwriteInterval 1;\n")
    (case / "case.foam").write_text("")
    return "case/case.foam"


def write_ensight(folder):
    """EnSight Gold, text: one part of hexahedra."""
    def column(values):
        return "\n".join(f"{v:12.5e}" for v in values)
    points, velocity = crossings(), flow(crossings())
    cells = [" ".join(f"{corner + 1:9d}" for corner in corners) for corners in hexahedra()]
    (folder / "g.case").write_text(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g.geo\nVARIABLE\nvector per node: U g.U\n")
    (folder / "g.geo").write_text(
        f"flow\nbox\nnode id assign\nelement id assign\npart\n{1:10d}\nbody\ncoordinates\n{len(points):10d}\n" +
        "\n".join(column(points[:, k]) for k in range(3)) +
        f"\nhexa8\n{len(cells):10d}\n" + "\n".join(cells) + "\n")
    (folder / "g.U").write_text(f"velocity\npart\n{1:10d}\ncoordinates\n" +
                                "\n".join(column(velocity[:, k]) for k in range(3)) + "\n")
    return "g.case"


STEADY = [write_exodus, write_exodus_moved, write_exodus_unmoved, write_netcdf, write_netcdf_turned, write_tecplot, write_plot3d, write_ensight]

if __name__ == "__main__":
    place = pathlib.Path("written")
    place.mkdir(exist_ok=True)
    for write in STEADY + [write_netcdf_times, write_nifti, write_foam]:
        print(write(place))
