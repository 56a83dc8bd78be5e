// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file says of an object's place and colour is in the picture of every method.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"
#include "tests/support/pictures.h"

namespace pellucid::compare {
namespace {

using namespace testing;
using nlohmann::json;

class PropertyAppearanceOfMethod : public ::testing::TestWithParam<std::string_view> {
 protected:
  const scene::MethodRow& row() const { return find_row("method", GetParam(), methods()); }
  bool is_truth() const { return GetParam() == methods().front().name; }
  scene::Rendering draw(const scene::Scene& scene) const { return render(row(), scene, {}, true); }
};

scene::Scene scene_of(const json& objects, const scene::GivenShapes& given, const char* lighting) {
  const json text{
      {"format", "pellucid-scene"}, {"version", 1},
      {"resolution", {90, 70}},     {"lighting", lighting},
      {"background", "#e6ffcc"},    {"camera", {{"eye", {0.2, 0.3, 5}}, {"target", {0, 0, 0}}}},
      {"objects", objects}};
  return scene::read_scene(text, {.given = given});
}

/// Squares of two triangles each, tilted; every triangle has a region of its own, 0, 1 or 2.
geometry::TriangleMesh regions(std::uint32_t n) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double x = 3.0 * i / n - 1.5, y = 3.0 * j / n - 1.5;
      mesh.positions.emplace_back(x, y, 0.3 * x - 0.2 * y);
    }
  std::mt19937 random(5);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
      for (int k = 0; k < 2; ++k) mesh.face_scalars["region"].push_back(double(random() % 3));
    }
  return mesh;
}

double nearest(const Rgba& pixel, const std::vector<glm::dvec4>& colors) {
  double least = 2;
  for (const glm::dvec4& color : colors) {
    double largest = 0;
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(double(pixel[c]) - color[c]));
    least = std::min(least, largest);
  }
  return least;
}

TEST_P(PropertyAppearanceOfMethod, FacesAreOfOneColourEach) {
  const auto shape = std::make_shared<scene::GivenShape>(regions(6));
  const json color{{"by", "region"}, {"map", {"red", "lime", "blue"}}};
  const scene::Scene scene = scene_of({{{"mesh", "regions"}, {"color", color}, {"opacity", 0.5}}},
                                      {{"regions", shape}}, "none");
  std::vector<glm::dvec4> expected{glm::dvec4(scene.background, 0)};
  for (int c = 0; c < 3; ++c) {
    Rgba face(0, 0, 0, 0.5f);
    face[c] = 1;
    expected.push_back(composite({face}, scene.background));
  }
  const scene::Rendering test = draw(scene), truth = render(methods().front(), scene, {}, true);
  std::size_t other_face = 0;
  for (std::size_t i = 0; i < test.image.pixels.size(); ++i) {
    // Nothing between two faces' colours. Half precision of one layer's weight is 5e-4 / 2 off, but
    // cancels; float sums and exponentials are float_composite off.
    EXPECT_LE(nearest(test.image.pixels[i], expected), float_composite) << "pixel " << i;
    const Rgba& t = truth.image.pixels[i];
    if (nearest(test.image.pixels[i], {glm::dvec4(t)}) > float_composite) ++other_face;
  }
  // Some 20 edges of 55 pixels, which OpenGL snaps to 1/256 pixel.
  EXPECT_LE(other_face, 12u);
}

/// Scaled, turned and shifted by another formula than the program's: quaternions, and normals from
/// the tangents that they stand on.
struct WrittenOut {
  Vec3 scale, axis;
  double degrees;
  Vec3 translation;

  Vec3 linear(const Vec3& x) const {
    const auto turn = glm::angleAxis(degrees * std::numbers::pi / 180, glm::normalize(axis));
    return turn * (scale * x);
  }
  void operator()(geometry::Vertices& vertices) const {
    for (Vec3& x : vertices.positions) x = linear(x) + translation;
    for (Vec3& n : vertices.normals) {
      const Vec3 a =
          glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
      const Vec3 b = glm::cross(n, a);
      n = glm::normalize(glm::cross(linear(a), linear(b)));
    }
  }
  json keys() const {
    const auto list = [](const Vec3& v) { return json{v.x, v.y, v.z}; };
    return {{"scale", list(scale)},
            {"rotate", {{"axis", list(axis)}, {"degrees", degrees}}},
            {"translate", list(translation)}};
  }
};

geometry::TriangleMesh bowl() {
  geometry::TriangleMesh mesh = regions(5);
  for (Vec3& x : mesh.positions) x.z = 0.2 * glm::dot(x, x), mesh.normals.emplace_back(0, 0, 1);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.normals[i] =
        glm::normalize(Vec3(-0.4 * mesh.positions[i].x, -0.4 * mesh.positions[i].y, 1));
  return mesh;
}

template <class Shape>
Shape zigzag() {
  Shape shape;
  for (int i = 0; i < 8; ++i) shape.positions.emplace_back(0.4 * i - 1.5, i % 2, 0.1 * i);
  return shape;
}

scene::GivenShapes shapes(const auto& change) {
  geometry::TriangleMesh mesh = bowl();
  auto lines = zigzag<geometry::LineSet>();
  lines.offsets = {0, 8};
  auto points = zigzag<geometry::PointSet>();
  change(mesh), change(lines), change(points);
  const auto given = [](auto shape) {
    return std::make_shared<scene::GivenShape>(std::move(shape));
  };
  return {{"bowl", given(mesh)}, {"zigzag", given(lines)}, {"dots", given(points)}};
}

json objects_of(bool round) {
  return {{{"mesh", "bowl"}, {"opacity", 0.4}, {"color", "steelblue"}},
          {{"lines", "zigzag"}, {"radius", 0.05}, {"profile", round ? "tube" : "ribbon"}},
          {{"points", "dots"}, {"radius", 0.1}, {"profile", round ? "sphere" : "disc"}}};
}

json moved(json objects, const WrittenOut& how) {
  for (json& object : objects) object["transform"] = how.keys();
  return objects;
}

TEST_P(PropertyAppearanceOfMethod, AMovedObjectIsThatOfTheMovedCoordinates) {
  const WrittenOut how{{0.9, -0.6, 1.1}, {1, 2, -0.5}, 37, {0.2, -0.1, 0.3}};
  const auto stay = [](geometry::Vertices&) {};
  const scene::Scene by_key =
      scene_of(moved(objects_of(is_truth()), how), shapes(stay), "headlight");
  const scene::Scene written = scene_of(objects_of(is_truth()), shapes(how), "headlight");
  const scene::Rendering a = draw(by_key), b = draw(written),
                         unmoved =
                             draw(scene_of(objects_of(is_truth()), shapes(stay), "headlight"));
  std::size_t other = 0;
  for (std::size_t i = 0; i < a.image.pixels.size(); ++i)
    if (nearest(a.image.pixels[i], {glm::dvec4(b.image.pixels[i])}) > 1e-5) ++other;
  // Coordinates differ by some 1e-16, of float coordinates by one rounding where a double lies
  // between two: of an outline of 500 pixels one in 1e5 goes to the other side.
  EXPECT_LE(other, 2u);
  EXPECT_GT(largest_difference(a.image, unmoved.image), 0.05);
}

TEST(PropertyTransformOfScene, QuartersOfATurnAreExactToTheLastBit) {
  // (x, y, z) → (-2 y + 1, 2 x, 2 z), written out without any rounding.
  const auto by_hand = [](geometry::Vertices& vertices) {
    for (Vec3& x : vertices.positions) x = Vec3(-2 * x.y + 1, 2 * x.x, 2 * x.z);
    for (Vec3& n : vertices.normals) n = Vec3(-n.y, n.x, n.z);
  };
  const WrittenOut how{Vec3(2), {0, 0, 3}, 90, {1, 0, 0}};
  const auto stay = [](geometry::Vertices&) {};
  const scene::Scene a = scene_of(moved(objects_of(true), how), shapes(stay), "none");
  const scene::Scene b = scene_of(objects_of(true), shapes(by_hand), "none");
  EXPECT_EQ(render(methods().front(), a).image.pixels, render(methods().front(), b).image.pixels);
}

std::vector<std::string_view> names_of_methods() {
  std::vector<std::string_view> names;
  for (const scene::MethodRow& row : methods()) names.push_back(row.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Methods, PropertyAppearanceOfMethod,
                         ::testing::ValuesIn(names_of_methods()), method_test_name);

}  // namespace
}  // namespace pellucid::compare
