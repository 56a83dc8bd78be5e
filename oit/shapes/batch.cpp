// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace pellucid::oit {
namespace {

// A draw call counts vertices in a signed 32-bit integer.
// A crossing of a solid has the six vertices of a rectangle.
constexpr std::uint64_t most_primitives = (std::uint64_t(1) << 31) / 3;
constexpr std::uint64_t most_crossings = most_primitives / 2;

// Of an isosurface; more than one in a pixel at one depth, to a float, are of neighbouring cells.
constexpr std::uint64_t crossings_told_apart = std::uint64_t(1) << 24;

struct CountPrimitives {
  std::uint64_t operator()(const geometry::TriangleMesh& mesh) { return mesh.triangles.size(); }
  std::uint64_t operator()(const scene::LineObject& lines) { return 2 * lines.set.segment_count(); }
  std::uint64_t operator()(const scene::PointObject& points) {
    const bool spheres = points.profile == scene::PointObject::Profile::sphere;
    return (spheres ? 2 : 1) * points.set.positions.size();
  }
  std::uint64_t operator()(const scene::Isosurface&) { return crossings_told_apart; }
};

/// What Batch::others is, of a kind; `units` of a kind are those passed by.
template <class Units>
std::uint32_t others_of(ShapeKind kind, const Units& units) {
  switch (kind) {
    case ShapeKind::mesh:
      return 0;
    case ShapeKind::ribbon:
      return units(ShapeKind::tube);
    case ShapeKind::tube:
      return units(ShapeKind::ribbon);
    case ShapeKind::disc:
      return units(ShapeKind::sphere);
    case ShapeKind::sphere:
      return units(ShapeKind::disc);
    case ShapeKind::isosurface:
    case ShapeKind::fading_isosurface:
      return 0;
  }
  return 0;
}

/// Whether an object that starts a batch at `place` can be drawn together with the one before it;
/// an isosurface, whose batch is empty yet, with none.
bool continues(const Batch& batch, const Batch& object, const PrimitiveRange& place) {
  return batch.kind == object.kind && batch.kind != ShapeKind::isosurface &&
         batch.opaque == object.opaque && batch.lighting == object.lighting &&
         batch.first_primitive + batch.count == place.first;
}

}  // namespace

ShapeKind kind_of(const scene::SceneObject& object) {
  if (std::holds_alternative<scene::Isosurface>(object.shape)) return ShapeKind::isosurface;
  if (const auto* lines = std::get_if<scene::LineObject>(&object.shape))
    return lines->profile == scene::LineObject::Profile::tube ? ShapeKind::tube : ShapeKind::ribbon;
  if (const auto* points = std::get_if<scene::PointObject>(&object.shape))
    return points->profile == scene::PointObject::Profile::sphere ? ShapeKind::sphere
                                                                  : ShapeKind::disc;
  return ShapeKind::mesh;
}

std::uint64_t primitive_count(const scene::SceneObject& object) {
  return std::visit(CountPrimitives(), object.shape);
}

std::vector<PrimitiveRange> primitive_ranges(const scene::Scene& scene) {
  std::vector<PrimitiveRange> ranges;
  std::uint64_t total = 0;
  for (const scene::SceneObject& object : scene.objects) {
    const std::uint64_t n = primitive_count(object), first = total;
    const std::uint64_t most = is_solid(kind_of(object)) ? most_crossings : most_primitives;
    if ((total += n) >= most)
      throw InputError(fmt::format("{}: {} primitives in the scene; accepted: fewer than {}",
                                   object.name, total, most));
    ranges.push_back(
        {std::uint32_t(first), std::uint32_t(first + std::max<std::uint64_t>(n, 1)) - 1});
  }
  return ranges;
}

std::vector<Batch> make_batches(const scene::Scene& part, std::span<const PrimitiveRange> places) {
  std::vector<Batch> batches;
  std::array<std::uint32_t, shape_kinds.size()> of_kind{};  // primitives
  const auto units = [&](ShapeKind kind) {
    return of_kind[std::size_t(kind)] / primitives_of_unit(kind);
  };
  std::int64_t passed = 0;  // triangles, segments and points
  for (std::size_t i = 0; i < part.objects.size(); ++i) {
    const scene::SceneObject& object = part.objects[i];
    const ShapeKind kind = kind_of(object);
    const auto n = kind == ShapeKind::isosurface ? 0 : std::uint32_t(primitive_count(object));
    std::uint32_t& first = of_kind[std::size_t(kind)];
    const Batch own{kind,
                    object.opaque,
                    scene::lighting_of(part, object),
                    places[i].first,
                    places[i].last,
                    first,
                    first,
                    first,
                    0,
                    passed - units(kind),
                    others_of(kind, units)};
    if (batches.empty() || !continues(batches.back(), own, places[i])) batches.push_back(own);
    batches.back().count += n;
    batches.back().last_primitive = places[i].last;
    first += n;
    batches.back().last_of_kind = std::max(first, 1u) - 1;
    if (!object.opaque) passed += n / primitives_of_unit(kind);
  }
  return batches;
}

std::vector<Batch> make_batches(const scene::Scene& scene) {
  return make_batches(scene, primitive_ranges(scene));
}

}  // namespace pellucid::oit
