// SPDX-License-Identifier: GPL-3.0-or-later
// A file that was written gives every scalar back under its name, or was refused.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class UnitScalarNames : public FormatFiles {
 protected:
  static TriangleMesh triangle(const std::vector<std::string>& names, bool colored) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    if (colored) mesh.colors.assign(3, Rgba(0.5f));
    for (const std::string& name : names) mesh.scalars[name] = {0.25, 0.5, 0.75};
    return mesh;
  }
  /// Whether a file came to be; what it says is held to what was written.
  bool is_written(const std::string& file, const TriangleMesh& mesh) const {
    const fs::path path = folder_ / file;
    try {
      write_mesh(path, mesh);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(file), HasSubstr("accepted: another name")));
      EXPECT_FALSE(fs::exists(path));
      return false;
    }
    const TriangleMesh back = read_mesh(path);
    EXPECT_EQ(back.scalars, mesh.scalars) << file;
    EXPECT_EQ(back.colors, mesh.colors) << file;
    EXPECT_TRUE(back.normals.empty());
    fs::remove(path);
    return true;
  }
};

TEST_F(UnitScalarNames, ComeBackOrAreRefused) {
  const std::vector<std::vector<std::string>> names = {{"s"},
                                                       {"Q criterion"},
                                                       {"x"},
                                                       {"red"},
                                                       {"alpha"},
                                                       {"Alpha"},
                                                       {""},
                                                       {"a\nb"},
                                                       {"a\tb"},
                                                       {"importance"},
                                                       {"RGBA"},
                                                       {"vtkGhostType"},
                                                       {"line"},
                                                       {"nx"},
                                                       {"nx", "ny", "nz"},
                                                       {"red", "green", "blue"},
                                                       {"R", "G", "B"},
                                                       {"Red", "Green", "Blue"},
                                                       {"a<b&\"c\""},
                                                       {"α"}};
  for (const char* file : {"a.ply", "a.vtp", "a.vtu"})
    for (const bool colored : {false, true})
      for (const auto& some : names) is_written(file, triangle(some, colored));
}

TEST_F(UnitScalarNames, OfNoDangerAreWritten) {
  EXPECT_TRUE(is_written("a.ply", triangle({"red"}, false)));
  EXPECT_TRUE(is_written("a.ply", triangle({"a<b", "line", "nx"}, true)));
  EXPECT_FALSE(is_written("a.ply", triangle({"Q criterion"}, false)));
  for (const char* file : {"a.vtp", "a.vtu"}) {
    EXPECT_TRUE(is_written(file, triangle({"Q criterion", "x", "a<b&\"c\""}, true))) << file;
    EXPECT_TRUE(is_written(file, triangle({"alpha", "red"}, false))) << file;
    EXPECT_FALSE(is_written(file, triangle({"alpha"}, true))) << file;
  }
}

TEST_F(UnitScalarNames, TheNumberOfALineIsTheFilesOwn) {
  LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}};
  lines.offsets = {0, 2};
  lines.scalars["line"] = {1, 2};
  EXPECT_THAT(refusal([&] { write_lines(folder_ / "a.ply", lines); }),
              HasSubstr("a.ply: the scalar 'line' cannot be written"));
  write_lines(folder_ / "a.vtp", lines);
  EXPECT_EQ(read_lines(folder_ / "a.vtp").scalars, lines.scalars);
}

}  // namespace
}  // namespace pellucid::geometry
