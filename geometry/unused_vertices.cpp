// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/unused_vertices.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace pellucid::geometry {
namespace {

/// Takes away the vertices that are not used, if there are any.
bool keep_used(const std::vector<bool>& used, std::string_view what, Vertices& vertices) {
  const auto unused = std::ranges::count(used, false);
  if (unused == 0) return false;
  const auto keep = [&](auto& values) {
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < used.size(); ++i)
      if (used[i]) values[kept++] = values[i];
    values.resize(kept);
  };
  keep(vertices.positions);
  keep(vertices.normals);
  keep(vertices.colors);
  keep(vertices.importance);
  for (auto& [name, values] : vertices.scalars) keep(values);
  vertices.remarks.push_back(
      fmt::format("{} of {} vertices are of no {}, and are left out", unused, used.size(), what));
  return true;
}

}  // namespace

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  if (!keep_used(used, "triangle", mesh)) return;
  std::vector<std::uint32_t> place(used.size());
  for (std::uint32_t i = 0, kept = 0; i < used.size(); ++i) {
    place[i] = kept;
    kept += used[i] ? 1 : 0;
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
}

void drop_unused_vertices(LineSet& lines) {
  std::vector<bool> used(lines.positions.size());
  std::vector<std::uint64_t> offsets{0};
  for (std::size_t k = 0; k < lines.line_count(); ++k) {
    const std::uint64_t begin = lines.offsets[k], end = lines.offsets[k + 1];
    const bool joins = end - begin > 1;
    if (joins)
      std::fill(used.begin() + std::ptrdiff_t(begin), used.begin() + std::ptrdiff_t(end), true);
    offsets.push_back(offsets.back() + (joins ? end - begin : 0));
  }
  if (keep_used(used, "segment", lines)) lines.offsets = std::move(offsets);
}

}  // namespace pellucid::geometry
