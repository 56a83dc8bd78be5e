// SPDX-License-Identifier: GPL-3.0-or-later
// Files that other programs wrote: VTK's grids, .binlines, comma-separated points.

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::string refusal(const auto& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted";
  return {};
}

/// A tetrahedron, a polyline of three points over two of its corners, and speeds at the points.
constexpr const char* legacy_grid = R"(# vtk DataFile Version 3.0
tetrahedron and line
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0
1 0 0
0 1 0
0 0 1
2 0 0
CELLS 2 9
4 0 1 2 3
3 0 1 4
CELL_TYPES 2
10
4
POINT_DATA 5
SCALARS speed double 1
LOOKUP_TABLE default
1 2 3 4 5
SCALARS pressure double 1
LOOKUP_TABLE default
10 20 30 40 50
)";

TEST(UnitVtkGeometry, AnUnstructuredGridGivesItsBoundaryItsLinesAndItsPoints) {
  const TemporaryFolder folder;
  const fs::path path = folder / "grid.vtk";
  write_text(path, legacy_grid);
  const TriangleMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  const LineSet lines = read_lines(path);
  ASSERT_EQ(lines.line_count(), 1u);
  EXPECT_EQ(lines.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(lines.scalars.at("speed"), (std::vector<double>{1, 2, 5}));
  EXPECT_EQ(lines.scalars.at("pressure"), (std::vector<double>{10, 20, 50}));
  const PointSet points = read_points(path);
  EXPECT_EQ(points.positions.size(), 5u);
  EXPECT_EQ(points.scalars.at("pressure"), (std::vector<double>{10, 20, 30, 40, 50}));
}

TEST(UnitVtkGeometry, LegacyPolygonsAreRead) {
  const TemporaryFolder folder;
  const fs::path path = folder / "square.vtk";
  write_text(path,
             "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
             "0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 1 5\n4 0 1 2 3\n");
  EXPECT_EQ(read_mesh(path).triangles.size(), 2u);
}

TEST(UnitVtkGeometry, AMissingOrTruncatedFileIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([] { read_lines("missing.vtk"); }), HasSubstr("missing.vtk: cannot read"));
  EXPECT_THAT(refusal([] { read_lines("missing.vtu"); }), HasSubstr("missing.vtu: cannot read"));
  const std::string whole = legacy_grid;
  write_text(folder / "cut.vtk", whole.substr(0, whole.find("CELL_TYPES")));
  EXPECT_THROW(read_mesh(folder / "cut.vtk"), InputError);
}

/// A .binlines file, number by number.
class BinLines {
 public:
  BinLines& number(std::uint32_t value) { return bytes(&value, sizeof value); }
  BinLines& floats(const std::vector<float>& values) {
    return bytes(values.data(), sizeof(float) * values.size());
  }
  BinLines& text(const std::string& value) {
    return number(std::uint32_t(value.size())).bytes(value.data(), value.size());
  }
  const std::string& content() const { return content_; }

 private:
  BinLines& bytes(const void* data, std::size_t count) {
    content_.append(static_cast<const char*>(data), count);
    return *this;
  }

  std::string content_;
};

/// Two lines with two attributes, as version 1 or 2.
std::string two_lines(std::uint32_t version) {
  BinLines file;
  file.number(version).number(2).number(2);
  file.number(2).floats({0, 0, 0, 1, 0, 0}).floats({0.25f, 0.75f}).floats({1, 2});
  file.number(3).floats({5, 5, 5, 6, 6, 6, 7, 7, 7}).floats({0, 0.5f, 1}).floats({3, 4, 5});
  if (version == 2) {
    file.number(0).number(1).text("importance").text("speed");
    file.number(0).number(0).number(0).number(0);  // no ribbons, no outline
  }
  return file.content();
}

TEST(UnitBinLines, BothVersionsAreRead) {
  const TemporaryFolder folder;
  const fs::path path = folder / "tracks.binlines";
  for (const std::uint32_t version : {1u, 2u}) {
    write_text(path, two_lines(version));
    const LineSet lines = read_lines(path);
    EXPECT_EQ(lines.offsets, (std::vector<std::uint64_t>{0, 2, 5}));
    EXPECT_EQ(lines.positions[4], Vec3(7));
    const std::vector<double> speeds{1, 2, 3, 4, 5};
    EXPECT_EQ(lines.scalars.at(version == 1 ? "attribute1" : "speed"), speeds);
    if (version == 1) continue;
    EXPECT_EQ(lines.importance, (std::vector<float>{0.25f, 0.75f, 0, 0.5f, 1}));
  }
}

TEST(UnitBinLines, EveryTruncationIsRefused) {
  const TemporaryFolder folder;
  const fs::path path = folder / "cut.binlines";
  const std::string whole = two_lines(1);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_text(path, whole.substr(0, length));
    EXPECT_THAT(refusal([&] { read_lines(path); }), HasSubstr("cut.binlines: byte")) << length;
  }
}

TEST(UnitBinLines, NothingThatAFileClaimsSizesAnAllocation) {
  const TemporaryFolder folder;
  const fs::path path = folder / "claim.binlines";
  write_text(path, BinLines().number(1).number(0xffffffff).number(0).number(0xffffffff).content());
  EXPECT_THAT(refusal([&] { read_lines(path); }), HasSubstr("bytes, but 0 are left"));
  write_text(path, BinLines().number(3).content());
  EXPECT_THAT(refusal([&] { read_lines(path); }), HasSubstr("version 3 of .binlines"));
  write_text(path, BinLines().number(1).number(1).number(1u << 30).content());
  EXPECT_THAT(refusal([&] { read_lines(path); }), HasSubstr("attributes; accepted"));
}

TEST(UnitCsvPoints, ColumnsAreFoundByName) {
  const TemporaryFolder folder;
  const fs::path path = folder / "stars.csv";
  write_text(path, "\"mass\",x, y,z,importance\r\n2,0.5,1e-3,-4,1\r\n\r\n3,7,8,9,0.5\r\n");
  const PointSet points = read_points(path);
  EXPECT_EQ(points.positions, (std::vector<Vec3>{{0.5, 1e-3, -4}, {7, 8, 9}}));
  EXPECT_EQ(points.scalars.at("mass"), (std::vector<double>{2, 3}));
  EXPECT_EQ(points.importance, (std::vector<float>{1, 0.5f}));
  write_text(path, "Points:0,Points:1,Points:2\n1,2,3\n");
  EXPECT_EQ(read_points(path).positions, (std::vector<Vec3>{{1, 2, 3}}));
}

TEST(UnitCsvPoints, RefusalsNameTheLineAndTheColumn) {
  const TemporaryFolder folder;
  const fs::path path = folder / "stars.csv";
  const auto refusal_of = [&](const char* text) {
    write_text(path, text);
    return refusal([&] { read_points(path); });
  };
  EXPECT_THAT(refusal_of("a,b\n1,2\n"), AllOf(HasSubstr("stars.csv:1:"), HasSubstr("among a, b")));
  EXPECT_THAT(refusal_of("x,y,z\n1,2,3\n1,2\n"), HasSubstr("stars.csv:3: column 'z': ''"));
  EXPECT_THAT(refusal_of("x,y,z\n1,2,3,4\n"), HasSubstr("more than the 3 columns"));
  EXPECT_THAT(refusal_of("x,y,z\n1,two,3\n"), HasSubstr("column 'y': 'two'"));
  EXPECT_THAT(refusal_of("x,y,z\n1,nan,3\n"), HasSubstr("accepted: finite"));
  EXPECT_THAT(
      refusal_of("x,y,z\n1,2,3\n1,2,-1e301\n"),
      HasSubstr("stars.csv: vertex 1: z is -1e+301; accepted: finite numbers below 1e+300"));
  EXPECT_THAT(refusal_of("x,y,z\n"), HasSubstr("no points"));
  EXPECT_THAT(refusal_of(""), HasSubstr("no columns x, y, z"));
}

}  // namespace
}  // namespace pellucid::geometry
