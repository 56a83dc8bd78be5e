// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/ply/ply_lines.h"

#include <fmt/format.h>

#include <cstdint>

#include "core/error.h"

namespace pellucid::geometry {
namespace {

/// Puts the points of `order`, one after another, in the place of the vertices.
void reorder(const std::vector<std::uint32_t>& order, Vertices& vertices,
             VertexAttributes& attributes) {
  const auto pick = [&](auto& values) {
    std::remove_reference_t<decltype(values)> picked;
    picked.reserve(order.size());
    for (const std::uint32_t i : order) picked.push_back(values[i]);
    values = std::move(picked);
  };
  pick(vertices.positions);
  for (auto& [name, values] : attributes) pick(values);
}

std::uint32_t end_of_edge(const std::vector<double>& ends, std::size_t edge, std::size_t vertices,
                          const std::string& file) {
  const double end = ends[edge];
  if (!(end >= 0 && end < double(vertices)) || end != std::uint32_t(end))
    throw InputError(fmt::format("{}: edge {}: vertex index {}, but the file has {} vertices", file,
                                 edge, end, vertices));
  return std::uint32_t(end);
}

}  // namespace

void join_by_edges(VertexAttributes edges, const std::string& file, LineSet& lines,
                   VertexAttributes& attributes) {
  const auto first = edges.extract("vertex1"), second = edges.extract("vertex2");
  if (!first || !second)
    throw InputError(file + ": element 'edge': expected properties vertex1 and vertex2");
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < first.mapped().size(); ++i) {
    const std::size_t count = lines.positions.size();
    const std::uint32_t from = end_of_edge(first.mapped(), i, count, file);
    const std::uint32_t to = end_of_edge(second.mapped(), i, count, file);
    if (order.empty() || order.back() != from || !edges.empty()) {
      if (!order.empty()) lines.offsets.push_back(order.size());
      order.push_back(from);
    }
    order.push_back(to);
  }
  if (!order.empty()) lines.offsets.push_back(order.size());
  reorder(order, lines, attributes);
  for (const auto& [name, values] : edges) {
    std::vector<double>& column = attributes[name];
    for (const double value : values) column.insert(column.end(), 2, value);
  }
}

void join_by_number(const std::vector<double>& line, LineSet& lines) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i] != line[i - 1]) lines.offsets.push_back(i);
  lines.offsets.push_back(line.size());
}

}  // namespace pellucid::geometry
