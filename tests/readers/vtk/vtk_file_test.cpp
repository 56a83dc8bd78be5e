// SPDX-License-Identifier: GPL-3.0-or-later
// Files that VTK's readers do not survive, read through a process of its own.

#include "readers/vtk/vtk_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <vtkDataSet.h>

#include "core/error.h"
#include "core/files/child_reader.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "readers/vtk/vtk_formats.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class UnitVtkFile : public ::testing::Test {
 protected:
  /// The complaint about a file of this content; "" when it is read.
  std::string complaint_about(const std::string& name, const std::string& content) const {
    write_text(folder_ / name, content);
    return complaint_about(folder_ / name);
  }
  std::string complaint_about(const std::filesystem::path& path) const {
    try {
      read_vtk_data_set(path);
      return "";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(StartsWith(path.string()), Not(HasSubstr("\n"))));
      return error.what();
    }
  }

  testing::TemporaryFolder folder_;
};

std::string legacy(const std::string& cells) {
  return "# vtk DataFile Version 3.0\nx\nASCII\n" + cells;
}

std::string poly(const std::string& components, const std::string& indices,
                 const std::string& offsets) {
  return fmt::format(
      R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData><Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="1" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float32" Name="s" NumberOfComponents="{}" format="ascii">1 2 3</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Lines><DataArray type="Int64" Name="connectivity" format="ascii">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray></Lines></Piece></PolyData></VTKFile>
)",
      components, indices, offsets);
}

TEST_F(UnitVtkFile, WhatIsRightIsRead) {
  EXPECT_EQ(complaint_about("a.vtp", poly("1", "0 1 2", "3")), "");
  EXPECT_EQ(read_vtk_data_set(folder_ / "a.vtp")->GetNumberOfPoints(), 3);
  EXPECT_EQ(complaint_about("B.VTP", poly("1", "0 1 2", "3")), "");
}

TEST_F(UnitVtkFile, ACrashIsAComplaint) {
#if defined(__SANITIZE_ADDRESS__)
  const char* const crashed = "its reader ended with code 1";  // by the sanitizer, before a signal
#elif defined(__SANITIZE_THREAD__)
  const char* const crashed = "its reader ended with code 66";
#else
  const char* const crashed = "its reader crashed";
#endif
  EXPECT_THAT(
      complaint_about("a.vtk", legacy("DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
                                      "POLYGONS 1 4\n900000000 0 1 2\n")),
      AnyOf(HasSubstr(crashed), HasSubstr("claims more than")));
}

TEST_F(UnitVtkFile, IndicesAndOffsetsAreChecked) {
  EXPECT_THAT(complaint_about("a.vtp", poly("1", "0 1 500000000", "3")),
              HasSubstr("point index 500000000"));
  EXPECT_THAT(complaint_about("a.vtp", poly("1", "0 1 4294967298", "3")),
              HasSubstr("point index 4294967298"));
  EXPECT_NE(complaint_about("a.vtp", poly("1", "0 1 2", "900000000")), "");
}

TEST_F(UnitVtkFile, MemoryIsBoundedByTheFilesSize) {
  EXPECT_THAT(complaint_about("a.vtp", poly("2147483647", "0 1 2", "3")), HasSubstr("not a valid"));
}

TEST_F(UnitVtkFile, OnlyFilesAreRead) {
  EXPECT_THAT(complaint_about(folder_ / "none.vtu"), HasSubstr("No such file"));
  EXPECT_THAT(complaint_about(folder_.path()), HasSubstr("directory"));
  ASSERT_EQ(::mkfifo((folder_ / "pipe.vtu").c_str(), 0600), 0);
  EXPECT_THAT(complaint_about(folder_ / "pipe.vtu"), HasSubstr("a pipe"));
}

/// Whoever opens what a file names would wait as well: this process for blocks of blocks.
TEST_F(UnitVtkFile, NorAreOthersThatAFileNames) {
  for (const char* name : {"pipe.vtu", "pipe.vtm", "pipe.q", "pipe.raw"})
    ASSERT_EQ(::mkfifo((folder_ / name).c_str(), 0600), 0);
  for (const char* named : {"pipe.vtu", "pipe.vtm"})
    EXPECT_THAT(complaint_about("whole.vtm",
                                fmt::format(R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0">
<vtkMultiBlockDataSet><DataSet index="0" file="{}"/></vtkMultiBlockDataSet></VTKFile>
)",
                                            named)),
                HasSubstr("a pipe"));
  EXPECT_THAT(complaint_about("pipe.xyz", "2 2 2\n"), HasSubstr("a pipe"));
  EXPECT_THAT(complaint_about("a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: pipe.raw\n"),
              HasSubstr("a pipe"));
  EXPECT_THAT(complaint_about("a.nhdr",
                              "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\n"
                              "encoding: raw\ndata file: pipe.raw\n"),
              HasSubstr("a pipe"));
}

TEST_F(UnitVtkFile, TheFileAndItsReaderAreNoted) {
  const FilesRead read;
  complaint_about("a.vtp", poly("1", "0 1 2", "3"));
  EXPECT_TRUE(read.paths().contains(folder_ / "a.vtp"));
  EXPECT_EQ(read.paths().size(), 2u);  // another reader may read it otherwise
}

/// What else lies in the folder, such as what an earlier run left there, is no input.
TEST_F(UnitVtkFile, OfACaseInAFolderItsOwnFilesAreNoted) {
  const auto beside = [&](const char* name) {
    std::vector<std::string> names;
    for (const auto& file : files_beside(folder_ / name, *vtk_format(folder_ / name)))
      names.push_back(file.lexically_relative(folder_.path()).string());
    return names;
  };
  write_text(folder_ / "e.case",
             "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 \"e.geo\"\nVARIABLE\n"
             "vector per node: 1 U e.***.U\nTIME\nnumber of steps: 2\ntime values: 0 1\n");
  for (const char* name : {"e.geo", "e.000.U", "e.001.U", "e.x.U", "line.vtp"})
    write_text(folder_ / name, "x");
  EXPECT_THAT(beside("e.case"), ElementsAre("e.000.U", "e.001.U", "e.geo"));
  write_text(folder_ / "c.foam", "");
  for (const char* folder :
       {"constant/polyMesh", "0.5", "system", "postProcessing/0", "processor0/1"})
    std::filesystem::create_directories(folder_ / folder);
  for (const char* name : {"constant/polyMesh/points", "0.5/U", "system/controlDict", "log.foam",
                           "postProcessing/0/p.vtp", "processor0/1/U", "processor0/s.vtp"})
    write_text(folder_ / name, "x");
  EXPECT_THAT(beside("c.foam"), ElementsAre("0.5/U", "constant/polyMesh/points", "processor0/1/U",
                                            "system/controlDict"));
}

TEST(UnitChildReader, AProgramThatIsNotThereFailsTheWork) {
  const testing::TemporaryFolder folder;
  write_text(folder / "a.vtk", "x");
  EXPECT_THROW(read_in_child("pellucid-read-nothing", folder / "a.vtk"), WorkError);
}

TEST(UnitChildReader, LimitsGrowWithTheFile) {
  EXPECT_EQ(read_limits(0).bytes, std::uint64_t(1) << 30);
  EXPECT_EQ(read_limits(0).cpu_seconds, 5u);
  EXPECT_GT(read_limits(1 << 30).bytes, std::uint64_t(64) << 30);
  EXPECT_EQ(read_limits(1 << 30).cpu_seconds, 5u + 1024);
  EXPECT_GT(read_limits(0).wall_seconds, read_limits(0).cpu_seconds);
}

/// VTK 9.1 counts without an end where an array has 2^31 components or more.
TEST_F(UnitVtkFile, SlowAnEndlessLoopIsEnded) {
  const std::string complaint = complaint_about("a.vtp", poly("-2147483648", "0 1 2", "3"));
  EXPECT_THAT(complaint, AnyOf("", HasSubstr("takes over 5 s"), HasSubstr("not a valid")));
}

}  // namespace
}  // namespace pellucid::readers
