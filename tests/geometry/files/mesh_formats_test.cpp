// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/mesh_formats.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "core/error.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

TEST(UnitMeshFormats, EveryRowHasAnEndingOfItsOwnATitleAndAReader) {
  std::set<std::string_view> endings;
  for (const FormatRow& row : mesh_formats()) {
    EXPECT_TRUE(row.ending.starts_with('.') && row.ending.size() > 1) << row.ending;
    EXPECT_TRUE(std::ranges::none_of(row.ending, [](unsigned char c) { return std::isupper(c); }));
    EXPECT_TRUE(endings.insert(row.ending).second) << row.ending << " twice";
    EXPECT_FALSE(row.title.empty()) << row.ending;
    EXPECT_TRUE(row.read_mesh || row.read_lines || row.read_points) << row.ending;
  }
}

TEST(UnitMeshFormats, WhatIsWrittenCanBeRead) {
  for (const FormatRow& row : mesh_formats()) {
    EXPECT_TRUE(!row.write_mesh || row.read_mesh) << row.ending;
    EXPECT_TRUE(!row.write_lines || row.read_lines) << row.ending;
    EXPECT_TRUE(!row.write_points || row.read_points) << row.ending;
  }
}

TEST(UnitMeshFormats, AFileIsKnownByItsEndingInAnyCase) {
  for (const FormatRow& row : mesh_formats()) {
    std::string capitals(row.ending);
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return std::toupper(c); });
    EXPECT_EQ(mesh_format("a.b/mesh" + std::string(row.ending)), &row);
    EXPECT_EQ(mesh_format("mesh" + capitals), &row);
  }
  EXPECT_EQ(mesh_format("mesh"), nullptr);
  EXPECT_EQ(mesh_format("mesh.none"), nullptr);
}

TEST(UnitMeshFormats, PointsComeBackFromEveryFormatThatIsWritten) {
  const TemporaryFolder folder;
  PointSet points;
  points.positions = {{0.1, 0, 1e7}, {1, 2, 3}};
  points.importance = {0.5f, 1};
  for (const FormatRow& row : mesh_formats()) {
    const auto path = folder / ("points" + std::string(row.ending));
    if (!row.write_points) {
      EXPECT_THROW(write_points(path, points), InputError) << row.ending;
      continue;
    }
    write_points(path, points);
    EXPECT_EQ(read_points(path).positions, points.positions) << row.ending;
    EXPECT_EQ(read_points(path).importance, points.importance) << row.ending;
  }
}

/// A newline would end a comment, and a backslash at its end go on with the next line.
TEST(UnitMeshFormats, EveryWrittenFileSaysWhereItIsFrom) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  LineSet lines;
  lines.positions = mesh.positions;
  lines.offsets = {0, 3};
  const std::string origin = "trace --field <a&b>\nelement \\";
  const auto expect_said = [&](const std::filesystem::path& path) {
    const std::string text = read_text(path);
    EXPECT_THAT(text, HasSubstr("trace --field <a&b>\\nelement \\; by pellucid ")) << path;
  };
  for (const FormatRow& row : mesh_formats()) {
    const auto path = folder / ("from" + std::string(row.ending));
    if (row.write_mesh) {
      write_mesh(path, mesh, origin);
      expect_said(path);
      EXPECT_EQ(read_mesh(path).triangles, mesh.triangles) << row.ending;
    }
    if (row.write_lines) {
      write_lines(path, lines, origin);
      expect_said(path);
      EXPECT_EQ(read_lines(path).positions, lines.positions) << row.ending;
    }
    if (row.write_points) {
      write_points(path, PointSet{Vertices(lines)}, origin);
      expect_said(path);
    }
  }
}

TEST(UnitMeshFormats, ARefusalListsTheEndingsThatHaveTheWriter) {
  try {
    write_lines("lines.csv", {});
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), EndsWith("accepted: " + endings_with(&FormatRow::write_lines)));
  }
  for (const FormatRow& row : mesh_formats())
    EXPECT_EQ(endings_with(&FormatRow::write_lines).find(row.ending) != std::string::npos,
              row.write_lines != nullptr)
        << row.ending;
}

}  // namespace
}  // namespace pellucid::geometry
