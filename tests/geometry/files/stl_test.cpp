// SPDX-License-Identifier: GPL-3.0-or-later
// Stereolithography, in its two forms; and the byte order mark that editors put before texts.

#include <fmt/format.h>
#include <vtkVersionMacros.h>

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;

/// A tetrahedron: its faces share four corners.
const std::vector<std::array<Vec3, 3>>& tetrahedron() {
  static const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  static const std::vector<std::array<Vec3, 3>> faces{{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
  return faces;
}

std::string text_stl() {
  std::string text = "solid t\n";
  for (const auto& face : tetrahedron()) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const Vec3& v : face) text += fmt::format("  vertex {} {} {}\n", v.x, v.y, v.z);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}

/// The head may begin as a text does.
std::string binary_stl() {
  std::string bytes = "solid but binary";
  bytes.resize(80, '\0');
  bytes += bytes_of(std::vector<std::uint32_t>{std::uint32_t(tetrahedron().size())});
  for (const auto& face : tetrahedron()) {
    std::vector<float> numbers(3, 0.f);
    for (const Vec3& v : face)
      for (int k = 0; k < 3; ++k) numbers.push_back(float(v[k]));
    bytes += bytes_of(numbers) + std::string(2, '\0');
  }
  return bytes;
}

using UnitStl = FormatFiles;

TEST_F(UnitStl, FacetsShareTheirCornersInBothForms) {
  for (const std::string& content : {text_stl(), binary_stl()}) {
    const TriangleMesh mesh = read_mesh(file("a.stl", content));
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.triangles.size(), 4u);
    double volume = 0;  // of a closed surface whose normals point outwards
    for (const auto& [a, b, c] : mesh.triangles)
      volume += glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c])) / 6;
    EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
  }
}

TEST_F(UnitStl, WhatIsCutOffIsRefused) {
  const std::string whole = binary_stl();
  for (const std::size_t size :
       {std::size_t(0), std::size_t(50), std::size_t(84), whole.size() - 60})
    EXPECT_THAT(refusal([&] { read_mesh(file("a.stl", whole.substr(0, size))); }),
                HasSubstr("a.stl"))
        << size;
  EXPECT_THAT(refusal([&] { read_mesh(file("a.stl", text_stl().substr(0, 200))); }),
              HasSubstr("a.stl: no 'endsolid'"));
}

using UnitByteOrderMark = FormatFiles;

TEST_F(UnitByteOrderMark, IsPassedOverInEveryText) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string vertices = "0 0 0\n1 0 0\n0 2 0\n";
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n"),
        {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
             vertices + "3 0 1 2\n"}}) {
    const TriangleMesh mesh = read_mesh(file(name, mark + content));
    ASSERT_EQ(mesh.positions.size(), 3u) << name;
    EXPECT_EQ(mesh.positions[2].y, 2) << name;
  }
}

TEST_F(UnitStl, TextMayBeInCapitals) {
  if (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0))
    GTEST_SKIP() << "VTK 9.6 takes it for a binary file, and refuses it";
  std::string capitals = text_stl();
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return std::toupper(c); });
  EXPECT_EQ(read_mesh(file("a.stl", capitals)).triangles,
            read_mesh(file("b.stl", text_stl())).triangles);
  EXPECT_THAT(refusal([&] { read_mesh(file("a.stl", capitals.substr(0, 200))); }),
              HasSubstr("a.stl: no 'endsolid'"));
}

}  // namespace
}  // namespace pellucid::geometry
