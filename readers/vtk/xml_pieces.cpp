// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_pieces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "readers/vtk/xml_extents.h"

namespace pellucid::readers {
namespace {

using Tags = std::span<const XmlTag>;

/// The arrays of points and of cells of one piece, by name.
struct PieceArrays {
  bool is_empty = false;
  std::vector<std::string> of_points, of_cells;
};

bool is_empty_piece(const XmlTag& piece) {
  const auto extent = extent_of(piece, "Extent");
  const auto points = piece.attributes.find("NumberOfPoints");
  return extent ? extent->is_empty() : points != piece.attributes.end() && points->second == "0";
}

/// Whether the arrays behind a tag are no more of points or of cells.
bool ends_group(std::string_view tag) {
  constexpr std::string_view tags[] = {"Piece",     "Points",  "Coordinates", "Cells",
                                       "Verts",     "Lines",   "Strips",      "Polys",
                                       "FieldData", "PPoints", "PCells",      "PCoordinates"};
  return std::ranges::find(tags, tag) != std::end(tags);
}

std::vector<PieceArrays> arrays_of_pieces(Tags tags) {
  std::vector<PieceArrays> pieces;
  std::vector<std::string>* names = nullptr;  // of the group that is open
  for (const XmlTag& tag : tags) {
    if (tag.name == "Piece") pieces.push_back({is_empty_piece(tag), {}, {}});
    if (ends_group(tag.name)) names = nullptr;
    if (tag.name == "PointData" && !pieces.empty()) names = &pieces.back().of_points;
    if (tag.name == "CellData" && !pieces.empty()) names = &pieces.back().of_cells;
    if (!names || (tag.name != "DataArray" && tag.name != "Array")) continue;
    const auto name = tag.attributes.find("Name");
    names->push_back(name == tag.attributes.end() ? "" : name->second);
  }
  std::erase_if(pieces, [](const PieceArrays& piece) { return piece.is_empty; });
  return pieces;
}

/// VTK takes the arrays of each piece for those of the first by their place, whatever they are
/// called, and leaves what a later piece does not have as memory was.
void check_arrays(Tags tags, const std::filesystem::path& path) {
  const std::vector<PieceArrays> pieces = arrays_of_pieces(tags);
  for (const PieceArrays& piece : pieces)
    for (const auto group : {&PieceArrays::of_points, &PieceArrays::of_cells})
      if (const auto& first = pieces.front().*group, &own = piece.*group; own != first)
        throw InputError(fmt::format(
            "{}: not a valid {} file: one of its pieces has the arrays '{}', another one '{}'; "
            "accepted: pieces that have the same in the same order",
            path.string(), path.extension().string(), fmt::join(first, "', '"),
            fmt::join(own, "', '")));
}

double count_in(const XmlTag& piece, std::string_view attribute) {
  const auto found = piece.attributes.find(attribute);
  double count = 0;
  if (found != piece.attributes.end()) std::istringstream(found->second) >> count;
  return count;
}

/// VTK 9.1 takes the first cells of a kind that it comes to for those of the first points, also
/// where a piece before theirs has points, and no such cells.
void check_first_cells(Tags tags, const std::filesystem::path& path) {
  constexpr std::string_view kinds[] = {"NumberOfCells", "NumberOfVerts", "NumberOfLines",
                                        "NumberOfStrips", "NumberOfPolys"};
  for (const std::string_view kind : kinds) {
    double points = 0;  // of the pieces before
    for (const XmlTag& tag : tags) {
      if (tag.name != "Piece") continue;
      const bool is_first = count_in(tag, kind) > 0;
      if (is_first && points > 0)
        throw InputError(
            fmt::format("{}: the first piece with {} above 0 stands behind one that has points and "
                        "none of these cells, which VTK reads wrong; accepted: one piece, or "
                        "such a piece first",
                        path.string(), kind));
      if (is_first) break;
      points += count_in(tag, "NumberOfPoints");
    }
  }
}

DeclaredWidths::Widths widths_of(Tags tags) {
  DeclaredWidths::Widths widths;
  enum class Of { neither, points, cells } of = Of::neither;  // what the arrays here are
  for (const XmlTag& tag : tags) {
    if (ends_group(tag.name)) of = Of::neither;
    if (tag.name == "PointData" || tag.name == "PPointData") of = Of::points;
    if (tag.name == "CellData" || tag.name == "PCellData") of = Of::cells;
    const auto name = tag.attributes.find("Name");
    if (of == Of::neither || name == tag.attributes.end() ||
        (tag.name != "DataArray" && tag.name != "PDataArray"))
      continue;
    const bool says_so = tag.attributes.contains("NumberOfComponents");
    widths[{of == Of::cells, name->second}] = says_so ? count_in(tag, "NumberOfComponents") : 1;
  }
  return widths;
}

}  // namespace

void check_pieces(Tags tags, const std::filesystem::path& path) {
  check_arrays(tags, path);
  check_first_cells(tags, path);
}

DeclaredWidths::DeclaredWidths(Tags tags, const std::filesystem::path& path)
    : widths_(widths_of(tags)), path_(path) {}

void DeclaredWidths::check_piece(Tags tags, const std::filesystem::path& piece) const {
  for (const auto& [array, width] : widths_of(tags))
    if (const auto found = widths_.find(array); found != widths_.end() && found->second != width)
      throw InputError(
          fmt::format("{}: its array '{}' has NumberOfComponents=\"{}\"; accepted: {}, as {} says",
                      piece.string(), array.second, width, found->second, path_.string()));
}

}  // namespace pellucid::readers
