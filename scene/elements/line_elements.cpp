// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "scene/elements/elements.h"

namespace pellucid::scene {
namespace {

/// call(object, points of a line that has a segment)
template <class Call>
void for_each_line(const Scene& scene, const Call& call) {
  for (const SceneObject& object : scene.objects)
    if (const auto* lines = std::get_if<LineObject>(&object.shape))
      for (std::size_t k = 0; k < lines->set.line_count(); ++k)
        call(object, std::span(lines->set.positions)
                         .subspan(lines->set.offsets[k],
                                  lines->set.offsets[k + 1] - lines->set.offsets[k]));
}

/// The distance of each point from the first one, along the line.
std::vector<double> arc_lengths(std::span<const Vec3> line) {
  std::vector<double> lengths(line.size());
  for (std::size_t i = 1; i < line.size(); ++i)
    lengths[i] = lengths[i - 1] + glm::length(line[i] - line[i - 1]);
  return lengths;
}

double total_length(const Scene& scene) {
  double total = 0;
  for_each_line(scene, [&](const SceneObject& object, std::span<const Vec3> line) {
    if (!object.opaque && line.size() > 1) total += arc_lengths(line).back();
  });
  return total;
}

/// Of the segment from point i to i + 1: which of `pieces` equal lengths has its middle.
std::size_t piece_of(const std::vector<double>& lengths, std::size_t i, std::size_t pieces) {
  const double middle = 0.5 * (lengths[i] + lengths[i + 1]), whole = lengths.back();
  if (!(whole > 0)) return 0;
  return std::min(pieces - 1, std::size_t(middle / whole * double(pieces)));
}

class LineCutter {
 public:
  explicit LineCutter(double length) : length_(length) {}

  void skip(std::span<const Vec3> line) {
    if (line.size() > 1)
      elements_.of_primitive.insert(elements_.of_primitive.end(), line.size() - 1, 0);
    for (std::size_t i = 0; i < line.size(); ++i) elements_.of_vertex.end_row();
  }

  void cut(std::span<const Vec3> line) {
    if (line.size() < 2) return skip(line);
    const std::vector<double> lengths = arc_lengths(line);
    const auto first = std::uint32_t(elements_.count());
    const std::vector<double> middles = cut_segments(lengths);
    link(first, std::uint32_t(middles.size()));
    for (const double length : lengths) mix(length, first, middles);
  }

  Elements result() { return std::move(elements_); }

 private:
  /// Returns where along the line each element has its middle.
  std::vector<double> cut_segments(const std::vector<double>& lengths) {
    const auto pieces =
        std::size_t(std::max(1.0, length_ > 0 ? std::round(lengths.back() / length_) : 1.0));
    const auto first = std::uint32_t(elements_.count());
    std::vector<double> middles;
    for (std::size_t i = 0, begin = 0; i + 1 < lengths.size(); ++i) {
      elements_.of_primitive.push_back(first + std::uint32_t(middles.size()));
      const bool last = i + 2 == lengths.size();
      if (!last && piece_of(lengths, i, pieces) == piece_of(lengths, i + 1, pieces)) continue;
      middles.push_back(0.5 * (lengths[begin] + lengths[i + 1]));
      begin = i + 1;
    }
    return middles;
  }

  void link(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > 0) elements_.neighbours.values.push_back(first + i - 1);
      if (i + 1 < count) elements_.neighbours.values.push_back(first + i + 1);
      elements_.neighbours.end_row();
    }
  }

  void mix(double at, std::uint32_t first, const std::vector<double>& middles) {
    const auto next = std::upper_bound(middles.begin(), middles.end(), at);
    const auto i = std::uint32_t(next - middles.begin());
    if (next == middles.begin()) {
      add(first, 1);
    } else if (next == middles.end()) {
      add(first + i - 1, 1);
    } else {
      const double share = (at - next[-1]) / (next[0] - next[-1]);
      add(first + i - 1, 1 - share);
      add(first + i, share);
    }
    elements_.of_vertex.end_row();
  }

  void add(std::uint32_t element, double weight) {
    elements_.of_vertex.values.push_back(element);
    elements_.weights.push_back(float(weight));
  }

  double length_;  // that an element shall have
  Elements elements_;
};

}  // namespace

Elements line_elements(const Scene& scene, std::size_t segments) {
  LineCutter cutter(total_length(scene) / double(segments));
  for_each_line(scene, [&](const SceneObject& object, std::span<const Vec3> line) {
    object.opaque ? cutter.skip(line) : cutter.cut(line);
  });
  return cutter.result();
}

}  // namespace pellucid::scene
