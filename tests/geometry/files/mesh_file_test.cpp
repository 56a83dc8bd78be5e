// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/mesh_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

/// Two triangles with every attribute, at coordinates that float would round.
TriangleMesh sample_mesh() {
  TriangleMesh mesh;
  mesh.positions = {{0.1, 0, 1e7}, {1.1, 0, 1e7}, {1.1, 1.0 / 3, 1e7}, {0.1, 1, 1e7 + 1e-6}};
  mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  mesh.colors = {{0, 0.25, 0.5, 1}, {1, 0, 0, 0.1f}, {0, 1, 0, 0.2f}, {0, 0, 1, 0}};
  mesh.importance = {0, 0.5f, 0.75f, 1};
  mesh.scalars["speed"] = {1, 2, 3, 1e-300};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::string refusal(const fs::path& path) {
  try {
    read_mesh(path);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " was accepted";
  return {};
}

class UnitMeshFile : public ::testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(UnitMeshFile, RoundTripKeepsWhatTheFormatCan) {
  const TriangleMesh mesh = sample_mesh();
  const fs::path path = folder_ / (std::string("mesh") + GetParam());
  write_mesh(path, mesh);
  const TriangleMesh read = read_mesh(path);
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_EQ(read.normals, mesh.normals);
  EXPECT_EQ(read.triangles, mesh.triangles);
  if (std::string_view(GetParam()) == ".obj") return;  // has no other attributes
  EXPECT_EQ(read.colors, mesh.colors);
  EXPECT_EQ(read.importance, mesh.importance);
  EXPECT_EQ(read.scalars, mesh.scalars);
}

template <class Number>
std::string raw_bytes(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// Puts one number into a file in the place of another, as bytes or as text.
void replace_number(const fs::path& path, double from, double to) {
  std::string file = read_text(path);
  for (const auto& [old, made] : {std::pair(raw_bytes(from), raw_bytes(to)),
                                  std::pair(raw_bytes(float(from)), raw_bytes(float(to))),
                                  std::pair(fmt::format("{}", from), fmt::format("{}", to))})
    if (const std::size_t at = file.find(old); at != file.npos) {
      file.replace(at, old.size(), made);
      return write_text(path, file);
    }
  FAIL() << path << " does not hold " << from;
}

TEST_P(UnitMeshFile, RefusesWhatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = sample_mesh();
    mesh.positions[2].y = 0x1.234567p+3;
    const fs::path path = folder_ / (std::string("mesh") + GetParam());
    write_mesh(path, mesh);
    replace_number(path, mesh.positions[2].y, bad);  // no writer takes it
    EXPECT_THAT(refusal(path), AllOf(HasSubstr(path.string()), HasSubstr("y")));
  }
}

TEST_P(UnitMeshFile, RefusesAnIndexOutOfRange) {
  TriangleMesh mesh = sample_mesh();
  mesh.triangles.push_back({0, 1, 4});
  const fs::path path = folder_ / (std::string("mesh") + GetParam());
  write_mesh(path, mesh);
  EXPECT_THAT(refusal(path), AllOf(HasSubstr(path.string()), HasSubstr("4")));
}

TEST_P(UnitMeshFile, EveryTruncationIsRefusedOrWhole) {
  const fs::path path = folder_ / (std::string("mesh") + GetParam());
  write_mesh(path, sample_mesh());
  const std::string whole = read_text(path);
  const std::size_t step = std::max<std::size_t>(whole.size() / 60, 7);  // each asks a reader anew
  for (std::size_t length = 0; length < whole.size(); length += step) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, length);
    try {
      // A cut between two lines of an OBJ file cannot be told from a shorter file.
      EXPECT_LE(read_mesh(path).triangles.size(), 2u);
    } catch (const InputError&) {
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, UnitMeshFile, ::testing::Values(".ply", ".obj", ".vtp", ".vtu"));

class UnitPly : public ::testing::Test {
 protected:
  fs::path file(const std::string& content) const {
    const fs::path path = folder_ / "sheet.ply";
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  static std::string ascii(const std::string& vertex_properties, const std::string& body,
                           int vertices = 3, int faces = 1) {
    return "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex " +
           std::to_string(vertices) + "\nproperty float x\nproperty float y\nproperty float z\n" +
           vertex_properties + "element face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n" + body;
  }
  TemporaryFolder folder_;
};

TEST_F(UnitPly, EightBitColoursCountIn255ths) {
  const TriangleMesh mesh = read_mesh(file(
      ascii("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float alpha\n",
            "0 0 0 255 51 0 0.5\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n")));
  EXPECT_EQ(mesh.colors[0], Rgba(1, 0.2f, 0, 0.5f));
}

TEST_F(UnitPly, PolygonsBecomeFans) {
  const TriangleMesh mesh =
      read_mesh(file(ascii("", "0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n", 5)));
  const std::vector<std::array<std::uint32_t, 3>> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(mesh.triangles, fan);
}

TEST_F(UnitPly, BigEndianIsRead) {
  std::string text =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar ushort vertex_indices\nend_header\n";
  const char one[] = {0x3f, char(0x80), 0, 0}, zero[] = {0, 0, 0, 0};
  for (const char* value : {zero, zero, zero, one, zero, zero, zero, one, zero})
    text.append(value, 4);
  text.append({3, 0, 0, 0, 1, 0, 2});
  const TriangleMesh mesh = read_mesh(file(text));
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.triangles[0][2], 2u);
}

TEST_F(UnitPly, NonManifoldTrianglesAreKept) {
  EXPECT_EQ(read_mesh(file(ascii("", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n3 1 0 2\n", 3, 3)))
                .triangles.size(),
            3u);
}

TEST_F(UnitPly, RefusalsNameTheLine) {
  EXPECT_THAT(refusal(file(ascii("", "0 0 0\n1 0 0\n0 1 0\n3 0 1 9041\n"))),
              HasSubstr("sheet.ply:14: face 0: vertex index 9041, but the file has 3 vertices"));
  EXPECT_THAT(refusal(file(ascii("", "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"))),
              HasSubstr("sheet.ply:12: 'zero': expected a number"));
  EXPECT_THAT(refusal(file("plx\n")), HasSubstr("sheet.ply:1"));
  EXPECT_THAT(refusal(file("ply\nformat ascii 1.0\nelement vertex many\n")),
              HasSubstr("sheet.ply:3"));
}

TEST_F(UnitPly, OpacityOutsideTheUnitIntervalIsRefused) {
  for (const char* alpha : {"1.5", "-0.1", "nan"})
    EXPECT_THAT(
        refusal(file(ascii("property float alpha\n",
                           "0 0 0 1\n1 0 0 " + std::string(alpha) + "\n0 1 0 1\n3 0 1 2\n"))),
        AllOf(HasSubstr("vertex 1"), HasSubstr("alpha"), HasSubstr("0 … 1")));
}

TEST_F(UnitPly, NothingThatAHeaderClaimsSizesAnAllocation) {
  EXPECT_THAT(refusal(file(ascii("", "0 0 0\n", 2000000000))), HasSubstr("declares 2000000000"));
}

TEST_F(UnitPly, NoTrianglesIsAnError) {
  EXPECT_THAT(refusal(file(ascii("", "0 0 0\n1 0 0\n0 1 0\n", 3, 0))), HasSubstr("no triangles"));
}

TEST(UnitMeshEnding, UnknownOnesAreRefusedWithTheKnown) {
  EXPECT_THAT(refusal("mesh.fbx"), HasSubstr("accepted: .ply, .obj, .vtp, .vtu, .vtk"));
  EXPECT_THAT(refusal("missing.ply"), HasSubstr("missing.ply: cannot read"));
  EXPECT_THAT(refusal("missing.vtp"), HasSubstr("missing.vtp: cannot read"));
}

TEST(UnitLineFile, EveryFormatIsWrittenAndRead) {
  const TemporaryFolder folder;
  LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 5, 5}, {6, 6, 6}};
  lines.offsets = {0, 3, 5};
  lines.scalars["t"] = {0, 1, 2, 0, 1};
  for (const char* ending : {".ply", ".obj", ".vtp"}) {
    const fs::path path = folder / (std::string("lines") + ending);
    write_lines(path, lines);
    const LineSet read = read_lines(path);
    EXPECT_EQ(read.positions, lines.positions) << ending;
    EXPECT_EQ(read.offsets, lines.offsets) << ending;
    if (ending != std::string_view(".obj")) {
      EXPECT_EQ(read.scalars, lines.scalars) << ending;
      EXPECT_EQ(read_points(path).positions, lines.positions) << ending;
    }
  }
  EXPECT_THAT(read_text(folder / "lines.obj"), HasSubstr("l 1 2 3\nl 4 5\n"));
}

TEST(UnitLineFile, AFileWithoutLinesIsRefused) {
  const TemporaryFolder folder;
  LineSet dots;
  dots.positions = {{0, 0, 0}, {1, 0, 0}};
  dots.offsets = {0, 1, 2};
  for (const char* name : {"dots.vtp", "dots.ply", "dots.obj"}) {
    write_lines(folder / name, dots);
    EXPECT_THROW(read_lines(folder / name), InputError) << name;
  }
}

}  // namespace
}  // namespace pellucid::geometry
