// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/halo.h"

#include <algorithm>

#include "scene/view/ribbon.h"

namespace pellucid::scene {
namespace {

class HaloBuilder {
 public:
  HaloBuilder(const LineObject& lines, const Scene& scene)
      : lines_(lines),
        frame_(camera_frame(scene.camera)),
        projection_(scene.camera.projection),
        color_(lines.halo->color.value_or(scene.background)) {}

  geometry::TriangleMesh build() {
    for (std::size_t k = 0; k < lines_.set.line_count(); ++k)
      add_line(lines_.set.offsets[k], lines_.set.offsets[k + 1]);
    return std::move(mesh_);
  }

 private:
  void add_line(std::size_t begin, std::size_t end) {
    // Of one width, since the halo has a side at a tip, too; 1 where the line is nothing but tips.
    const double largest = lines_.radius.of(begin, end - begin).largest();
    full_ = largest > 0 ? largest : 1;
    ribbon_half_widths(std::span(lines_.set.positions).subspan(begin, end - begin), full_, frame_,
                       projection_, half_widths_);
    for (const double side : {-1.0, 1.0}) {
      const auto first = std::uint32_t(mesh_.positions.size());
      for (std::size_t i = begin; i < end; ++i) add_rim(i, side * half_widths_[i - begin]);
      for (std::uint32_t i = 0; i + 1 < end - begin; ++i)
        for (const auto& [a, b, c] : ribbon_triangles(i))
          mesh_.triangles.push_back({first + a, first + b, first + c});
    }
  }

  /// `half_width` is that of the full radius.
  void add_rim(std::size_t i, const Vec3& half_width) {
    const Vec3& x = lines_.set.positions[i];
    const bool beside_the_eye = projection_ == Projection::perspective && x != frame_.eye;
    const Vec3 away = beside_the_eye ? glm::normalize(x - frame_.eye) : frame_.forward;
    const Halo& halo = *lines_.halo;
    const Vec3 rim = x + lines_.radius.at(i) / full_ * half_width;
    mesh_.positions.push_back(rim);
    mesh_.positions.push_back(rim + halo.width / full_ * half_width + halo.depth * away);
    for (int corner = 0; corner < 2; ++corner) {
      mesh_.normals.push_back(-away);
      mesh_.colors.emplace_back(color_, lines_.set.colors[i].a);
      if (!lines_.set.importance.empty()) mesh_.importance.push_back(lines_.set.importance[i]);
    }
  }

  const LineObject& lines_;
  CameraFrame frame_;
  Projection projection_;
  Vec3 color_;
  double full_ = 0;                // radius of half_widths_, world
  std::vector<Vec3> half_widths_;  // of the line's points
  geometry::TriangleMesh mesh_;
};

}  // namespace

void place_halos(Scene& scene) {
  std::erase_if(scene.objects, [](const SceneObject& object) { return object.is_halo; });
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto* lines = std::get_if<LineObject>(&scene.objects[i].shape);
    if (!lines || !lines->halo) continue;
    SceneObject halo{scene.objects[i].name + ", halo", HaloBuilder(*lines, scene).build(),
                     scene.objects[i].opaque};
    halo.is_halo = true;
    halo.lighting = scene.objects[i].lighting;
    scene.objects.insert(scene.objects.begin() + std::ptrdiff_t(++i), std::move(halo));
  }
}

}  // namespace pellucid::scene
