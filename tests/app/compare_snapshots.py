#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds `pellucid info` of simulations' snapshots to h5py, which wrote them. Exits with 77 where it is not installed."""

import sys
import tempfile
from pathlib import Path

from told_by_info import SKIPPED, array_of, end, expect, expect_in, failures, flat_bounds, info, refusal

try:
    import h5py
    import numpy
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)


def write_snapshot(path):
    """Gas with all that GADGET-4 writes of it, packed; dark matter whose mass is in the head; no type between."""
    random = numpy.random.default_rng(7)
    with h5py.File(path, "w") as file:
        head = file.create_group("Header")
        head.attrs["MassTable"] = numpy.array([0, 2.5, 0, 0, 0, 0])
        head.attrs["NumFilesPerSnapshot"] = numpy.int32(2)
        for name, count in (("PartType0", 70), ("PartType1", 30)):
            group = file.create_group(name)
            group.create_dataset("Coordinates", data=random.random((count, 3)).astype("f4") * 1000, compression="gzip")
            group.create_dataset("Velocities", data=random.normal(size=(count, 3)), chunks=(16, 3), shuffle=True)
            group.create_dataset("ParticleIDs", data=numpy.arange(count, dtype="u8"))
        gas = file["PartType0"]
        gas.create_dataset("Masses", data=random.random(70).astype(">f4"))
        gas.create_dataset("Density", data=random.random((70, 1)))
        gas.create_dataset("Names", data=numpy.array([b"x"] * 70))
        gas.create_dataset("Short", data=numpy.arange(5))


def compare_snapshot(path):
    write_snapshot(path)
    told = info(path)
    if told is None:
        return
    with h5py.File(path) as file:
        types = [file["PartType0"], file["PartType1"]]
        positions = numpy.concatenate([t["Coordinates"][:] for t in types]).astype(float)
        expect("snapshot: counts", [told["counts"]["points"]], [len(positions)])
        expect("snapshot: bounds", flat_bounds(told), [*positions.min(axis=0), *positions.max(axis=0)])
        velocities = numpy.concatenate([t["Velocities"][:] for t in types])
        columns = {f"Velocities_{axis}": velocities[:, c] for c, axis in enumerate("xyz")}
        columns["Masses"] = numpy.append(file["PartType0/Masses"][:].astype(float), 2.5)
        columns["Density"] = file["PartType0/Density"][:]
        columns["ParticleIDs"] = file["PartType0/ParticleIDs"][:].astype(float)
        columns["particle_type"] = numpy.array([0.0, 1.0])
        for name, numbers in columns.items():
            mine = array_of(told, name)
            if mine is None:
                failures.append(f"snapshot: no array {name}")
                continue
            expect(f"snapshot: {name}", mine["ranges"][0], [numbers.min(), numbers.max()])
    remarks = "\n".join(told["remarks"])
    for part in ("one of 2 files", "'PartType0/Names'", "'PartType0/Short' (5 x 1)", "'Density' is not there for"):
        expect_in("snapshot: remarks", remarks, part)


def refuse_snapshots(folder):
    """What is none, a group of other things, positions in a plane, positions of another file, a file cut short."""
    with h5py.File(folder / "other.h5", "w") as file:
        file.create_dataset("temperature", data=[1.0, 2.0])
    expect_in("other.h5", refusal(folder / "other.h5"), "it holds: temperature")
    with h5py.File(folder / "flat.hdf5", "w") as file:
        file.create_dataset("PartType0/Coordinates", data=[[1.0, 2.0]])
    expect_in("flat.hdf5", refusal(folder / "flat.hdf5"), "PartType0/Coordinates has 2 components; accepted: 3")
    with h5py.File(folder / "virtual.hdf5", "w") as file:
        layout = h5py.VirtualLayout(shape=(70, 3), dtype="f4")
        layout[:] = h5py.VirtualSource(folder / "a.hdf5", "PartType0/Coordinates", shape=(70, 3))
        file.create_virtual_dataset("PartType0/Coordinates", layout)
    expect_in("virtual.hdf5", refusal(folder / "virtual.hdf5"), "kept in other files")
    (folder / "text.hdf5").write_text("no numbers\n")
    expect_in("text.hdf5", refusal(folder / "text.hdf5"), "no HDF5 file")
    whole = (folder / "a.hdf5").read_bytes()
    (folder / "cut.hdf5").write_bytes(whole[: len(whole) // 2])
    expect_in("cut.hdf5", refusal(folder / "cut.hdf5"), "cut.hdf5: ")


def main():
    with tempfile.TemporaryDirectory() as folder:
        compare_snapshot(Path(folder) / "a.hdf5")
        refuse_snapshots(Path(folder))
    sys.exit(end())


main()
