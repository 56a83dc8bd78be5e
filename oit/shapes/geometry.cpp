// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/geometry.h"

#include <algorithm>
#include <numeric>

#include "oit/gl/bindings.h"
#include "oit/shapes/disc_upload.h"

namespace pellucid::oit {

Resources ElementTextures::resources() const {
  return {of_triangle.as_image(bindings::triangle_elements_image),
          of_segment.as_image(bindings::segment_elements_image),
          opacities.as_texture(bindings::element_opacities_texture)};
}

namespace {

/// A subset of triangles `indices` that is kept group by group: a segment has two triangles.
class Thinning {
 public:
  /// `indices` may be missing when nothing is kept of them.
  Thinning(const Buffer* indices, std::uint32_t group) : group_(group) {
    if (!indices) return;
    triangles_.resize(indices->bytes() / sizeof(IndexTriangle));
    indices->read(triangles_.data());
  }

  /// Keeps the groups of a batch whose number of all that is transparent is a multiple of n;
  /// returns what it became.
  Batch keep(const Batch& batch, std::uint32_t n) {
    Batch kept = batch;
    kept.first = std::uint32_t(kept_.size());
    for (std::uint32_t i = 0; i < batch.count; ++i) {
      const std::uint32_t of_kind = std::min(batch.first_of_kind + i, batch.last_of_kind);
      if ((batch.passed + of_kind / group_) % n == 0) kept_.push_back(triangles_[batch.first + i]);
    }
    kept.count = std::uint32_t(kept_.size()) - kept.first;
    return kept;
  }
  Buffer buffer(const Gl& gl) const { return {gl, kept_}; }

 private:
  std::uint32_t group_;
  std::vector<IndexTriangle> triangles_, kept_;
};

/// Keeps likewise every n-th of what is drawn without indices: discs and what is cast.
Batch keep_every(const Batch& batch, std::uint32_t n) {
  const std::uint32_t group = primitives_of_unit(batch.kind), units = batch.count / group;
  const auto passed = std::uint64_t(batch.passed + batch.first_of_kind / group);
  const auto phase = std::uint32_t((n - passed % n) % n);
  Batch kept = batch;
  kept.first += group * phase;
  kept.count = units > phase ? group * ((units - phase + n - 1) / n) : 0;
  return kept;
}

}  // namespace

Geometry::Geometry(const Gl& gl, const scene::Scene& scene)
    : Geometry(gl, scene, scene::depth_range(scene), primitive_ranges(scene)) {}

Geometry::Geometry(const Gl& gl, const scene::Scene& part, const scene::DepthRange& range,
                   std::span<const PrimitiveRange> places, const scene::PartNumber& number)
    : gl_(gl),
      view_(part, range),
      lighting_(scene::common_lighting(part)),
      batches_(make_batches(part, places)),
      uniforms_(Buffer::writable(gl, sizeof(ViewSpace::Uniforms))),
      no_attributes_(gl) {
  const auto has = [&](ShapeKind kind) {
    return std::ranges::any_of(batches_, [&](const Batch& b) { return b.kind == kind; });
  };
  if (has(ShapeKind::isosurface)) isosurfaces_.emplace(gl, part, view_, number);
  if (isosurfaces_) place_isosurfaces();
  primitive_count_ =
      std::accumulate(batches_.begin(), batches_.end(), std::uint64_t(0),
                      [](std::uint64_t sum, const Batch& batch) { return sum + batch.count; });
  if (has(ShapeKind::mesh)) meshes_ = upload_meshes(gl, part, view_);
  if (has(ShapeKind::ribbon)) ribbons_ = upload_ribbons(gl, part, view_);
  if (meshes_) draw_parts(ShapeKind::mesh, *meshes_);
  if (ribbons_) draw_parts(ShapeKind::ribbon, *ribbons_);
  if (has(ShapeKind::disc)) points_ = upload_discs(gl, part, view_);
  if (has(ShapeKind::sphere) || has(ShapeKind::tube)) solids_.emplace(gl, part, view_);
  for (const scene::SceneObject& object : part.objects)
    if (const auto* lines = std::get_if<scene::LineObject>(&object.shape))
      lines_.push_back({kind_of(object), lines->set.positions.size()});
  sample_at(Vec2(0.5));
}

Defines Geometry::defines() const {
  Defines defines;
  if (lighting_ != scene::Lighting::none) defines.emplace_back("LIT", 1);
  if (lighting_ == scene::Lighting::phong) defines.emplace_back("PHONG", 1);
  if (!lighting_) defines.emplace_back("LIT_BY_OBJECT", 1);
  if (view_.projection() == scene::Projection::orthographic)
    defines.emplace_back("ORTHOGRAPHIC", 1);
  if (solids_ && solids_->tapered()) defines.emplace_back("TAPERED", 1);
  if (isosurfaces_) defines.emplace_back("FADING_DEGREE", isosurfaces_->degree());
  return defines;
}

std::vector<ShapeKind> Geometry::kinds(bool opaque) const {
  std::vector<ShapeKind> kinds;
  for (const ShapeKind kind : shape_kinds)
    if (std::ranges::any_of(batches_,
                            [&](const Batch& b) { return b.kind == kind && b.opaque == opaque; }))
      kinds.push_back(kind);
  return kinds;
}

void Geometry::place_isosurfaces() {
  std::vector<Batch> placed;
  std::size_t surface = 0;
  for (const Batch& batch : batches_)
    if (batch.kind != ShapeKind::isosurface) {
      placed.push_back(batch);
    } else {
      const std::vector<Batch> parts = isosurfaces_->batches(surface++, batch);
      placed.insert(placed.end(), parts.begin(), parts.end());
    }
  batches_ = std::move(placed);
}

void Geometry::draw_parts(ShapeKind kind, const IndexedVertices& vertices) {
  const std::uint64_t all = vertices.indices.bytes() / sizeof(IndexTriangle);
  batches_ = with_parts(batches_, kind, vertices.clipped.cuts,
                        std::uint32_t(all - vertices.clipped.parts.size()));
}

void Geometry::upload_importance(const scene::Scene& scene) {
  if (meshes_) upload_mesh_importance(gl_, scene, *meshes_);
  if (ribbons_) upload_ribbon_importance(gl_, scene, *ribbons_);
  if (points_) point_importance_ = upload_disc_importance(gl_, scene);
}

void Geometry::set_mesh_opacities(std::span<const float> opacities) {
  if (meshes_) upload_opacities(gl_, opacities, 1, *meshes_);
}

void Geometry::set_line_opacities(std::span<const float> opacities) {
  if (ribbons_) upload_opacities(gl_, opacities_of(opacities, ShapeKind::ribbon), 2, *ribbons_);
  if (solids_) solids_->set_tube_opacities(opacities_of(opacities, ShapeKind::tube));
}

std::vector<float> Geometry::opacities_of(std::span<const float> line_opacities,
                                          ShapeKind kind) const {
  std::vector<float> chosen;
  for (const LineRun& run : lines_) {
    const std::span<const float> of_run = line_opacities.first(run.points);
    if (run.kind == kind) chosen.insert(chosen.end(), of_run.begin(), of_run.end());
    line_opacities = line_opacities.subspan(run.points);
  }
  return chosen;
}

void Geometry::sample_at(const Vec2& sample) const {
  uniforms_.write<ViewSpace::Uniforms>(
      [&](ViewSpace::Uniforms* out) { *out = view_.uniforms(sample); });
}

Resources Geometry::resources() const {
  using namespace bindings;
  Resources list{uniforms_.as_uniform_block(view_block)};
  if (points_) list.add(points_->as_texture(points_texture));
  if (point_importance_) list.add(point_importance_->as_texture(point_importances_texture));
  if (solids_) list.add(solids_->resources());
  if (isosurfaces_) list.add(isosurfaces_->resources());
  if (elements_) list.add(elements_->resources());
  return list;
}

Geometry::Source Geometry::everything() const {
  return {meshes_ ? &meshes_->indices : nullptr, ribbons_ ? &ribbons_->indices : nullptr, 1};
}

void Geometry::draw_all(const GeometryProgram& program, const glm::vec2& size, bool opaque) const {
  for (const Batch& batch : batches_)
    if (batch.opaque == opaque) draw_batch(program, size, batch, everything());
}

void Geometry::draw(const GeometryProgram& program, const glm::vec2& size,
                    const Subset& subset) const {
  for (const Batch& batch : subset.batches)
    draw_batch(program, size, batch,
               {&subset.mesh_indices, &subset.ribbon_indices, subset.stride_of_points});
}

void Geometry::draw_batch(const GeometryProgram& program, const glm::vec2& size, const Batch& batch,
                          const Source& source) const {
  const Program& of_kind = program.of(batch.kind);
  of_kind.use();
  of_kind.set_if_used("first_primitive", batch.first_primitive);
  of_kind.set_if_used("last_primitive", batch.last_primitive);
  of_kind.set_if_used("first_of_kind", batch.first_of_kind);
  of_kind.set_if_used("last_of_kind", batch.last_of_kind);
  of_kind.set_if_used("others", batch.others);
  of_kind.set_if_used("target_size", size);
  of_kind.set_if_used("lighting", int(batch.lighting));
  if (elements_) of_kind.set_if_used("first_point_element", elements_->first_point);
  if (batch.kind == ShapeKind::mesh) draw_indexed(*meshes_, *source.mesh_indices, batch);
  if (batch.kind == ShapeKind::ribbon) draw_indexed(*ribbons_, *source.ribbon_indices, batch);
  if (batch.kind == ShapeKind::disc) draw_discs(of_kind, batch, source.stride_of_points);
  if (is_cast(batch.kind)) draw_cast(of_kind, batch, source.stride_of_points);
}

void Geometry::draw_indexed(const IndexedVertices& vertices, const Buffer& indices,
                            const Batch& batch) const {
  gl_.BindVertexArray(vertices.array.id());
  gl_.VertexArrayElementBuffer(vertices.array.id(), indices.id());
  gl_.DrawElements(GL_TRIANGLES, GLsizei(3 * batch.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(sizeof(IndexTriangle) * batch.first));
}

void Geometry::draw_discs(const Program& program, const Batch& batch, std::uint32_t stride) const {
  program.set("first_point", batch.first);
  program.set("stride_of_points", stride);
  gl_.BindVertexArray(no_attributes_.id());
  gl_.DrawArrays(GL_TRIANGLES, 0, GLsizei(3 * batch.count));
}

void Geometry::draw_cast(const Program& program, const Batch& batch, std::uint32_t stride) const {
  const std::uint32_t first = batch.first / primitives_of_unit(batch.kind);
  program.set("first_record", is_solid(batch.kind) ? solids_->first(batch.kind) + first : first);
  program.set("stride_of_records", stride);
  gl_.BindVertexArray(no_attributes_.id());
  gl_.DrawArrays(GL_TRIANGLES, 0, GLsizei(6 * batch.count));
}

Subset Geometry::every(std::uint32_t n) const {
  const Source source = everything();
  Thinning meshes(source.mesh_indices, primitives_of_unit(ShapeKind::mesh));
  Thinning ribbons(source.ribbon_indices, primitives_of_unit(ShapeKind::ribbon));
  Subset subset;
  subset.stride_of_points = n;
  for (const Batch& batch : batches_) {
    if (batch.opaque) continue;
    if (batch.kind == ShapeKind::mesh) subset.batches.push_back(meshes.keep(batch, n));
    if (batch.kind == ShapeKind::ribbon) subset.batches.push_back(ribbons.keep(batch, n));
    if (batch.kind == ShapeKind::disc || is_cast(batch.kind))
      subset.batches.push_back(keep_every(batch, n));
  }
  subset.mesh_indices = meshes.buffer(gl_);
  subset.ribbon_indices = ribbons.buffer(gl_);
  return subset;
}

}  // namespace pellucid::oit
