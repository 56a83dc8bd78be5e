# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files of every format that the program reads, and what may happen to them."""

import json
import shutil
import struct
import subprocess
import sys
import zipfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS / "formats"))


def scene_of(objects):
    return json.dumps({"format": "pellucid-scene", "version": 1, "resolution": [16, 12],
                       "camera": {"eye": [0, 0, 4], "target": [0, 0, 0], "fov": 50},
                       "objects": objects})


def image_data(kind):
    n = 3
    values = " ".join(f"{-y} {x} 0.2" for _ in range(n) for y in range(n) for x in range(n))
    points = " ".join(f"{x} {y} {z}" for z in range(n) for y in range(n) for x in range(n))
    axis = " ".join(map(str, range(n)))
    array = f'<DataArray type="Float32" Name="v" NumberOfComponents="3" format="ascii">{values}</DataArray>'
    place = f'<DataArray type="Float32" NumberOfComponents="3" format="ascii">{points}</DataArray>'
    line = f'<DataArray type="Float32" format="ascii">{axis}</DataArray>'
    extent = f"0 {n - 1} " * 3
    inside = {"ImageData": "", "RectilinearGrid": f"<Coordinates>{line * 3}</Coordinates>",
              "StructuredGrid": f"<Points>{place}</Points>"}[kind]
    more = ' Origin="0 0 0" Spacing="1 1 1"' if kind == "ImageData" else ""
    return (f'<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian"><{kind} '
            f'WholeExtent="{extent}"{more}><Piece Extent="{extent}"><PointData Vectors="v">{array}'
            f"</PointData>{inside}</Piece></{kind}></VTKFile>\n").encode()


def unstructured():
    return (b'<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">'
            b'<UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="2"><PointData Vectors="v">'
            b'<DataArray type="Float32" Name="v" NumberOfComponents="3" format="ascii">'
            b"1 0 0 1 0 0 1 0 0 1 0 0 1 0 0</DataArray></PointData><Points>"
            b'<DataArray type="Float32" NumberOfComponents="3" format="ascii">'
            b"0 0 0 1 0 0 0 1 0 0 0 1 1 1 1</DataArray></Points><Cells>"
            b'<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 1 2 3 4</DataArray>'
            b'<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray>'
            b'<DataArray type="UInt8" Name="types" format="ascii">10 10</DataArray></Cells></Piece>'
            b"</UnstructuredGrid></VTKFile>\n")


def legacy():
    head = b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 3\n"
    values = b"".join(struct.pack(">3f", 1, 0.5, 0) for _ in range(27))
    return head + b"ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 27\nVECTORS v float\n" + values + b"\n"


def meta_image():
    values = b"".join(struct.pack("<3f", 1, 0.5, 0) for _ in range(27))
    return (b"NDims = 3\nDimSize = 3 3 3\nElementType = MET_FLOAT\nElementNumberOfChannels = 3\n"
            b"ElementDataFile = LOCAL\n" + values)


def nrrd():
    values = b"".join(struct.pack("<3f", 1, 0.5, 0) for _ in range(27))
    return (b"NRRD0004\ntype: float\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 3 3 3\nkinds: vector space "
            b"space space\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nendian: little\nencoding: raw\n\n" + values)


def mrc():
    head = struct.pack("<10i6f3i", 3, 3, 3, 2, 0, 0, 0, 3, 3, 3, 3, 3, 3, 90, 90, 90, 1, 2, 3)
    head = (head + bytes(208 - len(head)) + b"MAP " + bytes([0x44, 0x44, 0, 0])).ljust(1024, b"\0")
    return head + struct.pack("<27f", *range(27))


def stl():
    facet = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    return bytes(80) + struct.pack("<I", 2) + 2 * facet


def write_trx(path):
    head = {"DIMENSIONS": [9, 9, 9], "NB_STREAMLINES": 2, "NB_VERTICES": 5,
            "VOXEL_TO_RASMM": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("header.json", json.dumps(head))
        file.writestr("offsets.uint64", struct.pack("<3Q", 0, 2, 5))
        file.writestr("positions.3.float32", struct.pack("<15f", *(0.1 * i for i in range(15))))


OBJ = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nl 1 2 3\n"


def collections():
    """Files that name others."""
    pieces = ('<PPointData Vectors="v"><PDataArray type="Float32" Name="v" NumberOfComponents="3"/></PPointData>'
              '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints><Piece Source="field.vtu"/>')
    vtk = '<VTKFile type="{0}" version="1.0" byte_order="LittleEndian"><{0}>{1}</{0}></VTKFile>\n'.format
    times = '<DataSet timestep="0" file="field.vti"/><DataSet timestep="1" file="field.vti"/>'
    series = {"file-series-version": "1.0",
              "files": [{"name": "field.vti", "time": 0}, {"name": "field.vti", "time": 2}]}
    return {"fields.pvd": vtk("Collection", times).encode(),
            "fields.vtm": vtk("vtkMultiBlockDataSet", '<DataSet index="0" file="field.vtu"/>').encode(),
            "fields.pvtu": vtk("PUnstructuredGrid", pieces).encode(),
            "fields.series": json.dumps(series).encode()}


PAINTED = b"mtllib painted.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"
STUDY = {"format": "pellucid-study", "version": 1, "scenes": ["scene.json"], "reference": "raytrace",
         "methods": ["weighted-average", {"method": "fourier", "bands": [1, 2]}], "repeats": 1,
         "crops": {"scene": [2, 2, 8, 8]}, "probes": {"scene": [[3, 4]]}, "views": 2,
         "claims": [{"claim": "x", "by": "rmse", "order": ["fourier:bands=2", "weighted-average"]}]}

METHOD = {"format": "pellucid-glsl-method", "version": 1,
          "parameters": {"k": {"default": 2, "min": 1, "max": 4, "whole": True}},
          "textures": {"sum": {"format": "rgba32f"}, "bins": {"format": "r32ui", "layers": "k"}},
          "passes": [{"geometry": "method.glsl", "into": {"sum": "add"}, "images": ["bins"]},
                     {"screen": "screen.glsl", "reads": ["sum"]}]}
SHADER = b"void main() {\n  Fragment f = fragment();\n  sum = vec4(f.color, float(k)) * f.alpha;\n}\n"

# What is read by the name of another file, and what a field's name is followed by.
PART_OF = {"field.geo": "field.case", "field.U": "field.case", "field.q": "field.xyz", "method.glsl": "method.json",
           "painted.mtl": "painted.obj"}
OPTIONS = {".nc": ":array=u,v,w", ".tec": ":array=U,V,W", ".xyz": ":array=Velocity"}


class Seeds:
    """A file of every format and the command that reads it, made once by the program itself, by VTK's and SciPy's
    writers where they are installed, or taken from the fuzzing corpus."""

    def __init__(self, program, folder):
        self.folder = Path(folder)
        for name in ("mesh.ply", "mesh.vtp"):
            self.make(program, "data", "stack:layers=2", "-o", name)
        for name in ("lines.ply", "lines.vtp"):
            self.make(program, "data", "benzene:count=5,seed=1", "-o", name)
        self.make(program, "data", "dark-sky:count=40,seed=1", "-o", "points.ply")
        self.make(program, "data", "sphere-levels", "-o", "levels.vdb")
        for name, content in {
                "field.vti": image_data("ImageData"), "field.vtr": image_data("RectilinearGrid"),
                "field.vts": image_data("StructuredGrid"), "field.vtu": unstructured(),
                "field.vtk": legacy(), "field.mha": meta_image(), "field.nrrd": nrrd(), "mesh.obj": OBJ,
                "levels.mrc": mrc(), "mesh.stl": stl(), "painted.obj": PAINTED,
                "painted.mtl": b"newmtl a\nKd 1 0 0\nd 0.5\n", "study.json": json.dumps(STUDY).encode(),
                "points.csv": b"x,y,z,red\n0,0,0,1\n1,1,0,0.5\n0,1,1,0\n",
                "scene.json": scene_of([{"mesh": "mesh.ply", "opacity": 0.4},
                                        {"lines": "lines.ply", "radius": 0.05}]).encode()}.items():
            (self.folder / name).write_bytes(content)
        for name, content in {**collections(), "method.json": json.dumps(METHOD).encode(), "method.glsl": SHADER,
                              "screen.glsl": b"void main() { picture = texelFetch(sum, ivec2(0), 0); }\n"}.items():
            (self.folder / name).write_bytes(content)
        for name, target in {"mesh.off": "off/colors_and_normals", "mesh.glb": "gltf/triangle",
                             "lines.tck": "tck/little_endian", "lines.trk": "trk/values",
                             "lines.hair": "hair/full",
                             "lines.binlines": "binlines/version1"}.items():
            shutil.copy(TESTS.parent / "fuzz" / "corpus" / target, self.folder / name)
        write_trx(self.folder / "lines.trx")
        # Of OpenVDB's PointDataGrid<NullCodec>, 24 points of a density, which no writer in Python makes.
        shutil.copy(TESTS / "soak" / "points.vdb", self.folder / "points.vdb")
        self.write_by_others()
        self.write_snapshot()
        for name in ("a.exr", "a.png"):
            self.make(program, "render", "scene.json", "-m", "raytrace", "-o", name)
        self.make(program, "render", "scene.json", "-m", "raytrace", "--deep", "deep.exr", "--part", "1/1")
        self.make(program, "render", "scene.json", "-m", "weighted-average", "--partial", "sums.exr", "--part", "1/1")
        self.names = sorted(p.name for p in self.folder.iterdir())

    def write_by_others(self):
        try:
            import written_files as others
        except ImportError as missing:
            print(f"without files of other writers: {missing}")
            return
        apart = self.folder.parent / "others"
        apart.mkdir()
        for write in [*others.STEADY, others.write_nifti]:
            write(apart)
        for name in ("g.case", "g.geo", "g.U"):
            text = (apart / name).read_text().replace("g.geo", "field.geo").replace("g.U", "field.U")
            (self.folder / name.replace("g.", "field.")).write_text(text)
        for name in ("e.ex2", "n.nc", "t.tec", "p.xyz", "p.q", "i.nii.gz"):
            shutil.copy(apart / name, self.folder / ("field" + name[1:]))

    def write_snapshot(self):
        try:
            import h5py
        except ImportError as missing:
            print(f"without snapshots: {missing}")
            return
        with h5py.File(self.folder / "points.hdf5", "w") as file:
            for group in ("PartType0", "PartType1"):
                file[f"{group}/Coordinates"] = [[0.1 * i, 0, 0.2] for i in range(9)]
                file.create_dataset(f"{group}/Masses", data=[1.0] * 9, chunks=(4,), compression="gzip")

    def make(self, program, *arguments):
        subprocess.run([program, *arguments, "--quiet"], cwd=self.folder, capture_output=True, check=True)


def mutated(content, rng):
    """A few bytes, numbers or lengths of a file other than they were."""
    data = bytearray(content)
    for _ in range(rng.choice([1, 1, 2, 3, 8])):
        if not data:
            return b""
        at = rng.randrange(min(len(data), rng.choice([64, 600, 1 << 30])))
        kind = rng.randrange(7)
        if kind == 0:
            data[at] = rng.randrange(256)
        elif kind == 1:
            data[at] ^= 1 << rng.randrange(8)
        elif kind == 2:
            del data[at:at + rng.choice([1, 4, 64])]
        elif kind == 3:
            data[at:at] = data[at:at + rng.choice([1, 4, 64])]
        elif kind == 4:
            data[at:at + 4] = struct.pack("<i", rng.choice([-1, 2**31 - 1, -(2**31), 0, 1 << 20]))
        elif kind == 5:
            number = rng.choice([b"-1", b"4294967298", b"2147483647", b"1e999", b"nan", b"0", b"9e18"])
            while at < len(data) and not chr(data[at]).isdigit():
                at += 1
            end = at
            while end < len(data) and chr(data[end]).isdigit():
                end += 1
            data[at:end] = number
        else:
            del data[at:]
    return bytes(data)
