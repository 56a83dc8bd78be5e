// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace pellucid::oit {
namespace {

// A draw call counts vertices in a signed 32-bit integer.
constexpr std::uint64_t most_primitives = (std::uint64_t(1) << 31) / 3;

void check_shape(const scene::SceneObject& object) {
  if (std::holds_alternative<scene::Isosurface>(object.shape))
    throw InputError(fmt::format(
        "{}: an isosurface: raytrace and march draw it; accepted by this method: meshes, "
        "lines, points",
        object.name));
  const auto refuse = [&](const char* profile, const char* accepted) {
    throw InputError(fmt::format(
        "{}: profile \"{}\": raytrace and march draw it; accepted by this method: \"{}\"",
        object.name, profile, accepted));
  };
  if (const auto* lines = std::get_if<scene::LineObject>(&object.shape))
    if (lines->profile == scene::LineObject::Profile::tube) refuse("tube", "ribbon");
  if (const auto* points = std::get_if<scene::PointObject>(&object.shape))
    if (points->profile == scene::PointObject::Profile::sphere) refuse("sphere", "disc");
}

struct CountPrimitives {
  std::uint64_t operator()(const geometry::TriangleMesh& mesh) { return mesh.triangles.size(); }
  std::uint64_t operator()(const scene::LineObject& lines) { return 2 * lines.set.segment_count(); }
  std::uint64_t operator()(const scene::PointObject& points) { return points.set.positions.size(); }
  std::uint64_t operator()(const scene::Isosurface&) { return 0; }  // refused: see check_shape
};

/// Whether an object at that place can be drawn together with the batch before it.
bool continues(const Batch& batch, const scene::SceneObject& object, const PrimitiveRange& place) {
  return batch.kind == kind_of(object) && batch.opaque == object.opaque &&
         batch.first_primitive + batch.count == place.first;
}

}  // namespace

std::uint64_t primitive_count(const scene::SceneObject& object) {
  return std::visit(CountPrimitives(), object.shape);
}

std::vector<PrimitiveRange> primitive_ranges(const scene::Scene& scene) {
  std::vector<PrimitiveRange> ranges;
  std::uint64_t total = 0;
  for (const scene::SceneObject& object : scene.objects) {
    const std::uint64_t n = primitive_count(object), first = total;
    if ((total += n) >= most_primitives)
      throw InputError(fmt::format("{}: {} primitives in the scene; accepted: fewer than {}",
                                   object.name, total, most_primitives));
    ranges.push_back(
        {std::uint32_t(first), std::uint32_t(first + std::max<std::uint64_t>(n, 1)) - 1});
  }
  return ranges;
}

std::vector<Batch> make_batches(const scene::Scene& part, std::span<const PrimitiveRange> places) {
  std::vector<Batch> batches;
  std::array<std::uint32_t, shape_kinds.size()> of_kind{};
  std::int64_t passed = 0;  // triangles, segments and points
  for (std::size_t i = 0; i < part.objects.size(); ++i) {
    const scene::SceneObject& object = part.objects[i];
    check_shape(object);
    const ShapeKind kind = kind_of(object);
    const auto n = std::uint32_t(primitive_count(object));
    std::uint32_t& first = of_kind[std::size_t(kind)];
    if (batches.empty() || !continues(batches.back(), object, places[i]))
      batches.push_back({kind, object.opaque, places[i].first, places[i].last, first, first, first,
                         0, passed - first / triangles_of_unit(kind)});
    batches.back().count += n;
    batches.back().last_primitive = places[i].last;
    first += n;
    batches.back().last_of_kind = std::max(first, 1u) - 1;
    if (!object.opaque) passed += n / triangles_of_unit(kind);
  }
  return batches;
}

std::vector<Batch> make_batches(const scene::Scene& scene) {
  return make_batches(scene, primitive_ranges(scene));
}

}  // namespace pellucid::oit
