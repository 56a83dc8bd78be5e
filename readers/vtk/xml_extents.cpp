// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_extents.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"

namespace pellucid::readers {
namespace {

/// Pieces as boxes of samples, or of the cells between them, which a flat grid has one of along
/// its flat axis.
class Covering {
 public:
  Covering(const Extent& whole, bool of_cells) : whole_(whole), of_cells_(of_cells) {}

  double size_of(const Extent& box) const {
    double size = 1;
    for (std::size_t a = 0; a < 3; ++a) size *= std::max(0.0, double(end(box, a) - box.first(a)));
    return size;
  }
  bool overlap(const Extent& one, const Extent& other) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (one.first(a) >= end(other, a) || other.first(a) >= end(one, a)) return false;
    return true;
  }
  double covered_by(const std::vector<Extent>& pieces) const {
    double size = 0;
    for (const Extent& piece : pieces) size += size_of(piece);
    return size;
  }
  /// The first of the cells or samples that no piece holds; looked for where they are few.
  std::optional<std::array<std::int64_t, 3>> first_missing(
      const std::vector<Extent>& pieces) const {
    constexpr std::size_t few = 16;
    if (pieces.size() > few) return std::nullopt;
    std::array<std::vector<std::int64_t>, 3> begins;  // of what may be missing
    for (std::size_t a = 0; a < 3; ++a) {
      begins[a].push_back(whole_.first(a));
      for (const Extent& piece : pieces)
        if (end(piece, a) < end(whole_, a)) begins[a].push_back(end(piece, a));
      std::ranges::sort(begins[a]);
    }
    for (const std::int64_t z : begins[2])
      for (const std::int64_t y : begins[1])
        for (const std::int64_t x : begins[0])
          if (std::ranges::none_of(pieces, [&](const Extent& piece) {
                return holds(piece, {x, y, z});
              }))
            return std::array{x, y, z};
    return std::nullopt;
  }
  bool is_once(const std::vector<Extent>& pieces) const {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (overlap(pieces[i], pieces[j])) return false;
    return covered_by(pieces) == size_of(whole_);
  }

 private:
  bool holds(const Extent& box, const std::array<std::int64_t, 3>& at) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (at[a] < box.first(a) || at[a] >= end(box, a)) return false;
    return true;
  }
  std::int64_t end(const Extent& box, std::size_t axis) const {
    const bool adds_one = !of_cells_ || whole_.first(axis) == whole_.last(axis);
    return box.last(axis) + adds_one;
  }

  Extent whole_;
  bool of_cells_;
};

/// The tags of a structured grid in one file: its extent, its pieces', and whether there are arrays
/// of cells.
struct Pieces {
  XmlTag grid, last;
  std::optional<Extent> whole;
  std::vector<Extent> extents;
  bool has_cell_data = false;
};

Pieces pieces_of(std::span<const XmlTag> tags) {
  Pieces pieces;
  bool in_cells = false;
  for (const XmlTag& tag : tags) {
    if (const auto whole = extent_of(tag, "WholeExtent")) pieces.whole = whole, pieces.grid = tag;
    if (tag.name == "Piece") {
      pieces.last = tag;
      if (const auto extent = extent_of(tag, "Extent"); extent && !extent->is_empty())
        pieces.extents.push_back(*extent);
    }
    if (tag.name == "CellData") in_cells = true;
    if (tag.name == "PointData" || tag.name == "Piece") in_cells = false;
    pieces.has_cell_data |= in_cells && tag.name == "DataArray";
  }
  return pieces;
}

}  // namespace

std::optional<Extent> extent_of(const XmlTag& tag, std::string_view attribute) {
  const auto found = tag.attributes.find(attribute);
  if (found == tag.attributes.end()) return std::nullopt;
  Extent extent;
  std::istringstream stream(found->second);
  for (std::int64_t& end : extent.ends) stream >> end;
  return extent;
}

void check_extents(std::span<const XmlTag> tags, const std::filesystem::path& path) {
  const Pieces pieces = pieces_of(tags);
  if (!pieces.whole || pieces.whole->is_empty()) return;
  const auto& whole = pieces.grid.attributes.find("WholeExtent")->second;
  for (const Extent& piece : pieces.extents)
    for (std::size_t a = 0; a < 3; ++a)
      if (piece.first(a) < pieces.whole->first(a) || piece.last(a) > pieces.whole->last(a))
        refuse_attribute(path, pieces.last, "Extent", fmt::format("{}", fmt::join(piece.ends, " ")),
                         fmt::format("within WholeExtent=\"{}\"", whole));
  const Covering cells(*pieces.whole, true), points(*pieces.whole, false);
  if (cells.is_once(pieces.extents)) return;
  if (!pieces.has_cell_data && points.is_once(pieces.extents)) return;
  const auto missing = cells.first_missing(pieces.extents);
  throw InputError(
      fmt::format("{}: not a valid {} file: its {} {} {} of the {} cells of WholeExtent=\"{}\"{}; "
                  "accepted: pieces that hold each once",
                  path.string(), path.extension().string(), pieces.extents.size(),
                  pieces.extents.size() == 1 ? "piece holds" : "pieces hold",
                  cells.covered_by(pieces.extents), cells.size_of(*pieces.whole), whole,
                  missing ? fmt::format(", not the one at {}", fmt::join(*missing, " ")) : ""));
}

}  // namespace pellucid::readers
