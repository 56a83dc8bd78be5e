// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "core/options/option_table.h"
#include "scene/datasets/dataset.h"

namespace pellucid::scene {
namespace {

enum class Depths {
  even,   // from z = 1 to -1
  equal,  // all at z = 0
  ulp     // from z = 1 down, one ulp apart
};
enum class Order { front, back, shuffled };  // which sheets' triangles come first
enum class Sheet {
  square,   // two triangles
  grid,     // 64 x 64 x 2
  needles,  // a fan of 64 slivers and a triangle of no area
  line,     // a segment, to be drawn as a ribbon of radius 2
  point     // a point, to be drawn as a disc of radius 3
};

struct StackOptions {
  int layers = 8;
  double alpha = 0.3;  // opacity of each sheet
  Depths depths = Depths::even;
  Order order = Order::shuffled;
  Sheet sheet = Sheet::square;
  double scale = 1;        // world units
  double shift = 0;        // world units, along x, y and z
  std::uint32_t seed = 1;  // of the shuffled order
};

const OptionTable<StackOptions>& stack_options() {
  using Options = StackOptions;
  static const OptionTable<Options> table{
      number("layers", &Options::layers, {.min = 1, .max = 1e6, .unit = "sheets"}),
      number("alpha", &Options::alpha, {.min = 0, .max = 1, .help = "opacity of each sheet"}),
      choice("depths", &Options::depths,
             {{"even", Depths::even}, {"equal", Depths::equal}, {"ulp", Depths::ulp}},
             "even: from z = 1 to -1; equal: all at z = 0; ulp: from z = 1 down, one ulp apart"),
      choice("order", &Options::order,
             {{"front", Order::front}, {"back", Order::back}, {"shuffled", Order::shuffled}},
             "of the triangles: the front sheet first, the back sheet first, or by `seed`"),
      choice("sheet", &Options::sheet,
             {{"square", Sheet::square},
              {"grid", Sheet::grid},
              {"needles", Sheet::needles},
              {"line", Sheet::line},
              {"point", Sheet::point}},
             "a sheet: two triangles; 64 x 64 x 2, whose edges meet the centres of a picture of "
             "128 pixels; a fan of 64 slivers and a triangle of no area; or a line or a point, "
             "which cover what the camera sees as a ribbon of radius 2 `scale` or a disc of 3"),
      number("scale", &Options::scale, {.min = 1e-30, .max = 1e30, .unit = "world units"}),
      number("shift", &Options::shift,
             {.min = -1e30,
              .max = 1e30,
              .unit = "world units",
              .help = "of the stack along x, y and z"}),
      number("seed", &Options::seed, {.min = 0, .max = 1e9})};
  return table;
}

constexpr int pieces = 64;
/// Half a sheet's side: beyond the square [-1, 1]² that the camera sees.
constexpr double reach = 2;

double depth_of(Depths depths, int i, int layers) {
  if (depths == Depths::equal || layers == 1) return 0;
  if (depths == Depths::even) return 1 - 2.0 * i / (layers - 1);
  return 1 - i * std::numeric_limits<double>::epsilon() / 2;  // an ulp below 1
}

void add_square(std::uint32_t first, geometry::TriangleMesh& mesh) {
  for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    mesh.positions.emplace_back(reach * corner, 0);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_grid(std::uint32_t first, geometry::TriangleMesh& mesh) {
  constexpr std::uint32_t n = pieces, row = n + 1;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.emplace_back(reach * (2.0 * x / n - 1), reach * (2.0 * y / n - 1), 0);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = first + y * row + x;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
}

/// All slivers meet in one corner, so that most of them are needles.
void add_fan(std::uint32_t first, geometry::TriangleMesh& mesh) {
  constexpr std::uint32_t n = pieces / 2;
  mesh.positions.emplace_back(-reach, -reach, 0);
  for (std::uint32_t i = 0; i <= n; ++i)
    mesh.positions.emplace_back(reach, reach * (2.0 * i / n - 1), 0);
  for (std::uint32_t i = 1; i <= n; ++i)
    mesh.positions.emplace_back(reach * (1 - 2.0 * i / n), reach, 0);
  for (std::uint32_t i = 0; i < 2 * n; ++i)
    mesh.triangles.push_back({first, first + 1 + i, first + 2 + i});
  mesh.triangles.push_back({first, first + 1, first + 1});
}

void add_sheet(Sheet sheet, geometry::TriangleMesh& mesh) {
  const auto first = std::uint32_t(mesh.positions.size());
  switch (sheet) {
    case Sheet::square:
      return add_square(first, mesh);
    case Sheet::grid:
      return add_grid(first, mesh);
    case Sheet::needles:
      return add_fan(first, mesh);
    case Sheet::line:
    case Sheet::point:
      return;  // are no triangles
  }
}

/// The sheets, as numbers from the front, in the order in which they are drawn.
std::vector<int> drawing_order(const StackOptions& options) {
  std::vector<int> order(std::size_t(options.layers));
  std::iota(order.begin(), order.end(), 0);
  if (options.order == Order::back) std::reverse(order.begin(), order.end());
  // std::shuffle is not the same everywhere; this is (Fisher and Yates, by the raw generator).
  std::mt19937 random(options.seed);
  if (options.order == Order::shuffled)
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

/// Adds sheet i's vertices, at the corners of what it is made of.
void add_vertex(const StackOptions& options, const Vec2& at, int i, geometry::Vertices& to) {
  const double z = depth_of(options.depths, i, options.layers);
  to.positions.push_back(options.scale * Vec3(at, z) + Vec3(options.shift));
  to.colors.push_back(stack_color(i, options.alpha));
}

geometry::LineSet make_lines(const StackOptions& options) {
  geometry::LineSet lines;
  for (const int i : drawing_order(options)) {
    add_vertex(options, {-reach, 0}, i, lines);
    add_vertex(options, {reach, 0}, i, lines);
    lines.offsets.push_back(lines.positions.size());
  }
  return lines;
}

geometry::PointSet make_points(const StackOptions& options) {
  geometry::PointSet points;
  for (const int i : drawing_order(options)) add_vertex(options, {0, 0}, i, points);
  return points;
}

Dataset make(const Parameters& parameters, const Progress&) {
  const StackOptions options = stack_options().read(parameters);
  if (options.sheet == Sheet::line) return make_lines(options);
  if (options.sheet == Sheet::point) return make_points(options);
  const Vec3 shift(options.shift);
  geometry::TriangleMesh mesh;
  for (const int i : drawing_order(options)) {
    const std::size_t first = mesh.positions.size();
    const double z = depth_of(options.depths, i, options.layers);
    add_sheet(options.sheet, mesh);
    for (std::size_t k = first; k < mesh.positions.size(); ++k)
      mesh.positions[k] = options.scale * Vec3(Vec2(mesh.positions[k]), z) + shift;
    mesh.colors.resize(mesh.positions.size(), stack_color(i, options.alpha));
  }
  return mesh;
}

}  // namespace

Rgba stack_color(int i, double alpha) {
  const auto channel = [&](double phase) {
    return 0.5 + 0.5 * std::cos(2 * std::numbers::pi * (i / std::numbers::phi + phase));
  };
  return {channel(0), channel(1.0 / 3), channel(2.0 / 3), alpha};
}

// Square sheets above one another, for the extremes of a method's numbers: from an orthographic
// camera that looks along -z, every pixel is crossed by every sheet, and its exact colour is a sum
// that is known (Baeza Rojo et al. 2019, Eq. 12).
const DatasetRow& stack_dataset() {
  static const DatasetRow row{.name = "stack",
                              .title = "Sheets above one another",
                              .citation = "closed form: Baeza Rojo et al. 2019, Eq. 12",
                              .parameters = stack_options().specs(),
                              .make = make};
  return row;
}

}  // namespace pellucid::scene
