// SPDX-License-Identifier: GPL-3.0-or-later
// What has to hold of every kind of object that rays cross: nothing depends on order, threads,
// scale or place, and no number of layers is too large.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "groundtruth/methods/raytrace.h"
#include "groundtruth/sums/ray_sums.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

enum class Kind { triangles, ribbons, tubes, discs, spheres };

constexpr Kind all_kinds[] = {Kind::triangles, Kind::ribbons, Kind::tubes, Kind::discs,
                              Kind::spheres};

const char* name_of(Kind kind) {
  constexpr const char* names[] = {"triangles", "ribbons", "tubes", "discs", "spheres"};
  return names[int(kind)];
}

void PrintTo(Kind kind, std::ostream* out) { *out << name_of(kind); }

bool is_solid(Kind kind) { return kind == Kind::tubes || kind == Kind::spheres; }

scene::SceneObject lines_object(geometry::LineSet set, Kind kind, double radius) {
  using Profile = scene::LineObject::Profile;
  return {"lines", scene::LineObject{std::move(set), radius,
                                     kind == Kind::tubes ? Profile::tube : Profile::ribbon}};
}

scene::SceneObject points_object(geometry::PointSet set, Kind kind, double radius) {
  using Profile = scene::PointObject::Profile;
  return {"points", scene::PointObject{std::move(set), radius,
                                       kind == Kind::spheres ? Profile::sphere : Profile::disc}};
}

/// The indices 0 … count - 1, shuffled unless the seed is 0.
std::vector<std::size_t> order_of(std::size_t count, std::uint32_t shuffle_seed) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::mt19937 random(shuffle_seed);
  if (shuffle_seed != 0) std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// Random triangles, their outlines or their corners, in any order; all are moved by x ↦ scale x +
/// shift.
scene::SceneObject random_object(Kind kind, std::uint32_t shuffle_seed, double scale = 1,
                                 double shift = 0) {
  geometry::TriangleMesh mesh = random_triangles(100, 4);
  for (Vec3& x : mesh.positions) x = x * scale + shift;
  if (kind == Kind::triangles) {
    const auto triangles = mesh.triangles;
    const auto order = order_of(triangles.size(), shuffle_seed);
    for (std::size_t i = 0; i < order.size(); ++i) mesh.triangles[i] = triangles[order[i]];
    return {"triangles", mesh};
  }
  if (kind == Kind::ribbons || kind == Kind::tubes) {
    geometry::LineSet set;
    for (const std::size_t k : order_of(mesh.triangles.size(), shuffle_seed)) {
      for (const std::uint32_t corner : mesh.triangles[k]) {
        set.positions.push_back(mesh.positions[corner]);
        set.colors.push_back(mesh.colors[corner]);
      }
      set.offsets.push_back(set.positions.size());
    }
    return lines_object(std::move(set), kind, 0.05 * scale);
  }
  geometry::PointSet set;
  for (const std::size_t k : order_of(mesh.positions.size(), shuffle_seed)) {
    set.positions.push_back(mesh.positions[k]);
    set.colors.push_back(mesh.colors[k]);
  }
  return points_object(std::move(set), kind, 0.15 * scale);
}

scene::Scene random_scene(Kind kind, std::uint32_t shuffle_seed = 0, double scale = 1,
                          double shift = 0) {
  scene::Scene scene;
  scene.width = scene.height = 48;
  scene.camera = {.eye = Vec3(0, 0, 6) * scale + shift, .target = Vec3(shift)};
  scene.objects = {random_object(kind, shuffle_seed, scale, shift)};
  return scene;
}

scene::Rendering trace(const scene::Scene& scene) {
  const scene::MethodRow& row = raytrace_method();
  return row.make(scene, Parameters(row.name, row.parameters, {}), {})->render({.layers = true});
}

class PropertyEveryKind : public ::testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, PropertyEveryKind, ::testing::ValuesIn(all_kinds),
                         [](const auto& kind) { return name_of(kind.param); });

TEST_P(PropertyEveryKind, SamePictureForAnyOrderOfPrimitives) {
  const scene::Rendering picture = trace(random_scene(GetParam()));
  EXPECT_GT(picture.stats.fragments, 1000u);
  EXPECT_EQ(trace(random_scene(GetParam(), 7)).image.pixels, picture.image.pixels);
}

TEST_P(PropertyEveryKind, SamePictureForAnyThreadCount) {
  const Image many = trace(random_scene(GetParam())).image;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(trace(random_scene(GetParam())).image.pixels, many.pixels);
}

TEST_P(PropertyEveryKind, ScaleAndShiftChangeNothing) {
  const Image picture = trace(random_scene(GetParam())).image;
  const std::pair<double, double> cases[] = {{1e10, 0}, {1e-10, 0}, {1, 1e7}, {1e10, 1e17}};
  for (const auto& [scale, shift] : cases) {
    const Image other = trace(random_scene(GetParam(), 0, scale, shift)).image;
    // A shift by 1e7 rounds positions by 1e-9: pixels within 1e-9 of an outline may change sides,
    // which these do not have at 48².
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
      for (int c = 0; c < 4; ++c)
        ASSERT_NEAR(other.pixels[i][c], picture.pixels[i][c], 1e-6) << scale << " " << shift;
  }
}

/// 10⁵ crossings in each pixel, front to back from z = 1 to z = -1 or all at z = 0 (solids have two
/// each, and stay apart); white and black by turns.
struct Pile {
  static constexpr int crossings = 100000;
  static constexpr float alpha = 1e-4f;

  Kind kind;
  bool apart;

  int count() const { return is_solid(kind) ? crossings / 2 : crossings; }
  double z(int i) const { return apart ? 1 - 2.0 * i / (count() - 1) : 0; }
  static Rgba color(int i) { return i % 2 == 0 ? Rgba(1, 1, 1, alpha) : Rgba(0, 0, 0, alpha); }
  /// Of a tube or sphere: less than half the distance of two.
  double radius() const { return is_solid(kind) ? 0.75 / count() : 1; }

  scene::SceneObject object() const {
    if (kind == Kind::triangles) return sheets();
    if (kind == Kind::discs || kind == Kind::spheres) {
      geometry::PointSet set;
      for (int i = 0; i < count(); ++i) {
        set.positions.emplace_back(0, 0, z(i));
        set.colors.push_back(color(i));
      }
      return points_object(std::move(set), kind, radius());
    }
    geometry::LineSet set;
    for (int i = 0; i < count(); ++i) {
      set.positions.insert(set.positions.end(), {{-1, 0, z(i)}, {1, 0, z(i)}});
      set.colors.insert(set.colors.end(), 2, color(i));
      set.offsets.push_back(set.positions.size());
    }
    return lines_object(std::move(set), kind, radius());
  }

  scene::SceneObject sheets() const {
    geometry::TriangleMesh mesh;
    for (int i = 0; i < count(); ++i) {
      const geometry::TriangleMesh sheet = full_layer(z(i), color(i));
      const auto first = std::uint32_t(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), sheet.positions.begin(), sheet.positions.end());
      mesh.colors.insert(mesh.colors.end(), sheet.colors.begin(), sheet.colors.end());
      for (const auto& [a, b, c] : sheet.triangles)
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return {"sheets", mesh};
  }
};

void PrintTo(const Pile& pile, std::ostream* out) {
  *out << name_of(pile.kind) << (pile.apart ? "" : ", equal depths");
}

class UnitPile : public ::testing::TestWithParam<Pile> {};

INSTANTIATE_TEST_SUITE_P(Kinds, UnitPile,
                         ::testing::Values(Pile{Kind::triangles, true}, Pile{Kind::ribbons, true},
                                           Pile{Kind::tubes, true}, Pile{Kind::discs, true},
                                           Pile{Kind::spheres, true}, Pile{Kind::triangles, false},
                                           Pile{Kind::ribbons, false}, Pile{Kind::discs, false}));

TEST_P(UnitPile, HundredThousandLayersAreTheClosedForm) {
  const Pile pile = GetParam();
  scene::Scene scene = orthographic_scene(2, 2);
  scene.camera.height = pile.radius() / 2;  // the picture lies within what is drawn
  scene.background = Vec3(0);
  scene.objects = {pile.object()};
  const scene::Rendering rendering = trace(scene);
  for (const std::uint32_t layers : rendering.layers.pixels)
    ASSERT_EQ(layers, std::uint32_t(Pile::crossings));

  // White has the even places, single or in pairs: Σ α (1 - α)^i over them, a geometric series.
  const long double a = Pile::alpha, n = Pile::crossings;
  const long double shown = -std::expm1(n * std::log1p(-a));
  const long double white = is_solid(pile.kind) ? shown / (1 + (1 - a) * (1 - a)) : shown / (2 - a);
  const RaySums sums = RayProbe(scene).at(0.5, 0.5);
  // Each layer rounds the transmittance, and the sum, once: n halves of an ulp below 1.
  const double rounding = Pile::crossings * 1.2e-16;
  EXPECT_NEAR(sums.color.r, double(white), rounding);
  EXPECT_NEAR(sums.transmittance, double(1 - shown), rounding);
  // An ulp of a float below 1.
  for (const Rgba& pixel : rendering.image.pixels) EXPECT_NEAR(pixel.r, double(white), 6e-8);
}

TEST(UnitRaySums, TenThousandLayersStayWithinAPartInATrillion) {
  constexpr int n = 10000;
  const float alpha = 1e-3f;
  const scene::Scene scene = stack(n, 2, 2, [&](int) { return Rgba(1, 0.5, 0.25, alpha); });
  const RaySums sums = RayProbe(scene).at(0.5, 0.5);
  const long double t = std::exp(n * std::log1p(-static_cast<long double>(alpha)));
  // Each layer rounds the transmittance and the sum, up to 1, once: n · 1.1e-16.
  EXPECT_NEAR(sums.transmittance, double(t), n * 1.1e-16);
  EXPECT_NEAR(sums.color.g, double(0.5L * (1 - t) + t), 2 * n * 1.1e-16);
}

}  // namespace
}  // namespace pellucid::groundtruth
