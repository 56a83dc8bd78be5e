// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/options/parameters.h"
#include "readers/vtk/vtk_formats.h"
#include "readers/vtk/xml_tags.h"

namespace pellucid::readers {
namespace {

using Path = std::filesystem::path;

/// What an attribute has to hold.
enum class Kind { number, whole, count, positive };

struct NumbersRow {
  std::string_view attribute;
  std::size_t how_many;
  Kind kind;
};
constexpr NumbersRow numbers_table[] = {{"WholeExtent", 6, Kind::whole},
                                        {"Extent", 6, Kind::whole},
                                        {"Origin", 3, Kind::number},
                                        {"Spacing", 3, Kind::number},
                                        {"Direction", 9, Kind::number},
                                        {"NumberOfPoints", 1, Kind::count},
                                        {"NumberOfCells", 1, Kind::count},
                                        {"NumberOfVerts", 1, Kind::count},
                                        {"NumberOfLines", 1, Kind::count},
                                        {"NumberOfStrips", 1, Kind::count},
                                        {"NumberOfPolys", 1, Kind::count},
                                        {"NumberOfTuples", 1, Kind::count},
                                        {"NumberOfComponents", 1, Kind::positive},
                                        {"offset", 1, Kind::count},
                                        {"GhostLevel", 1, Kind::count}};

struct WordsRow {
  std::string_view attribute;
  std::vector<std::string_view> accepted;
};
const WordsRow words_table[] = {{"format", {"ascii", "binary", "appended"}},
                                {"encoding", {"raw", "base64"}},
                                {"byte_order", {"LittleEndian", "BigEndian"}},
                                {"header_type", {"UInt32", "UInt64"}}};

std::string accepted_by(const NumbersRow& row) {
  const std::string_view title = row.kind == Kind::number ? "number" : "whole number";
  const std::string_view limit = row.kind == Kind::count      ? " from 0 on"
                                 : row.kind == Kind::positive ? " from 1 on"
                                                              : "";
  return row.how_many == 1 ? fmt::format("a {}{}", title, limit)
                           : fmt::format("{} {}s{}", row.how_many, title, limit);
}

[[noreturn]] void refuse(const Path& path, const XmlTag& tag, std::string_view attribute,
                         const std::string& value, const std::string& accepted) {
  throw InputError(fmt::format("{}: not a valid {} file: <{}>: {}=\"{}\"; accepted: {}",
                               path.string(), path.extension().string(), tag.name, attribute, value,
                               accepted));
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_of(Kind kind, std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  if (kind == Kind::number) return parse_number(word, number) && std::isfinite(number);
  std::int64_t whole = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), whole);
  return error == std::errc() && end == word.data() + word.size() &&
         (kind == Kind::whole || whole >= (kind == Kind::positive ? 1 : 0));
}

void check_attributes(const XmlTag& tag, const Path& path) {
  for (const NumbersRow& row : numbers_table) {
    const auto found = tag.attributes.find(row.attribute);
    if (found == tag.attributes.end()) continue;
    const auto words = words_of(found->second);
    if (words.size() != row.how_many ||
        !std::ranges::all_of(words, [&](const auto& word) { return is_of(row.kind, word); }))
      refuse(path, tag, row.attribute, found->second, accepted_by(row));
  }
  for (const WordsRow& row : words_table)
    if (const auto found = tag.attributes.find(row.attribute);
        found != tag.attributes.end() &&
        std::ranges::find(row.accepted, found->second) == row.accepted.end())
      refuse(path, tag, row.attribute, found->second,
             fmt::format("{}", fmt::join(row.accepted, ", ")));
}

/// First and last sample along each axis.
struct Extent {
  std::array<std::int64_t, 6> ends{};

  std::int64_t first(std::size_t axis) const { return ends[2 * axis]; }
  std::int64_t last(std::size_t axis) const { return ends[2 * axis + 1]; }
  bool is_empty() const { return first(0) > last(0) || first(1) > last(1) || first(2) > last(2); }
};

std::optional<Extent> extent_of(const XmlTag& tag, std::string_view attribute) {
  const auto found = tag.attributes.find(attribute);
  if (found == tag.attributes.end()) return std::nullopt;
  Extent extent;
  std::istringstream stream(found->second);
  for (std::int64_t& end : extent.ends) stream >> end;
  return extent;
}

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

Pieces pieces_of(const std::vector<XmlTag>& tags) {
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

void check_pieces(const std::vector<XmlTag>& tags, const Path& path) {
  const Pieces pieces = pieces_of(tags);
  if (!pieces.whole || pieces.whole->is_empty()) return;
  const auto& whole = pieces.grid.attributes.find("WholeExtent")->second;
  for (const Extent& piece : pieces.extents)
    for (std::size_t a = 0; a < 3; ++a)
      if (piece.first(a) < pieces.whole->first(a) || piece.last(a) > pieces.whole->last(a))
        refuse(path, pieces.last, "Extent", fmt::format("{}", fmt::join(piece.ends, " ")),
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

std::vector<PieceArrays> arrays_of_pieces(const std::vector<XmlTag>& tags) {
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
void check_arrays(const std::vector<XmlTag>& tags, const Path& path) {
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
void check_first_cells(const std::vector<XmlTag>& tags, const Path& path) {
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

/// How many numbers a tuple of an array has, by whether it is of cells, and name: what a file says
/// of its own, or a file of pieces declares.
using Widths = std::map<std::pair<bool, std::string>, double>;

Widths widths_of(const std::vector<XmlTag>& tags) {
  Widths widths;
  std::optional<bool> of_cells;
  for (const XmlTag& tag : tags) {
    if (ends_group(tag.name)) of_cells.reset();
    if (tag.name == "PointData" || tag.name == "PPointData") of_cells = false;
    if (tag.name == "CellData" || tag.name == "PCellData") of_cells = true;
    const auto name = tag.attributes.find("Name");
    if (!of_cells || name == tag.attributes.end() ||
        (tag.name != "DataArray" && tag.name != "PDataArray"))
      continue;
    const bool says_so = tag.attributes.contains("NumberOfComponents");
    widths[{*of_cells, name->second}] = says_so ? count_in(tag, "NumberOfComponents") : 1;
  }
  return widths;
}

/// What a file of pieces says of them all.
struct Declared {
  Widths widths;
  const Path& file;
};

/// VTK copies the numbers of a piece as if they were as many as are declared.
void check_widths(const std::vector<XmlTag>& tags, const Declared& declared, const Path& path) {
  for (const auto& [array, width] : widths_of(tags))
    if (const auto found = declared.widths.find(array);
        found != declared.widths.end() && found->second != width)
      throw InputError(
          fmt::format("{}: its array '{}' has NumberOfComponents=\"{}\"; accepted: {}, as {} says",
                      path.string(), array.second, width, found->second, declared.file.string()));
}

bool is_structured(std::string_view ending) {
  return ending == ".vti" || ending == ".vtr" || ending == ".vts";
}

/// `declared`: by the file of pieces that names this one, which may hold less than it says; else
/// none.
void check_file(const Path& path, const Declared* declared, int depth) {
  constexpr int deepest = 4;  // blocks of pieces of blocks; a file may name itself
  const VtkFormat* const format = vtk_format(path);
  std::error_code code;
  if (depth > deepest || !format || !is_xml(*format)) return;
  if (!std::filesystem::is_regular_file(path, code)) return;  // VTK says so
  const std::vector<XmlTag> tags = xml_tags_before_data(path);
  for (const XmlTag& tag : tags) check_attributes(tag, path);
  if (is_structured(format->ending) && !declared) check_pieces(tags, path);
  if (declared) check_widths(tags, *declared, path);
  if (format->beside != Beside::named) {
    check_arrays(tags, path);
    return check_first_cells(tags, path);
  }
  const Declared own{widths_of(tags), path};
  const bool names_pieces = format->ending.starts_with(".pvt");
  for (const XmlTag& tag : tags)
    for (const char* key : {"file", "Source"})
      if (const auto name = tag.attributes.find(key); name != tag.attributes.end())
        check_file(path.parent_path() / name->second, names_pieces ? &own : nullptr, depth + 1);
}

}  // namespace

bool is_xml(const VtkFormat& format) {
  const std::string_view ending = format.ending;
  return (ending.starts_with(".vt") || ending.starts_with(".pvt")) && ending != ".vtk" &&
         ending != ".vtkhdf";
}

void check_xml(const Path& path) { check_file(path, nullptr, 0); }

}  // namespace pellucid::readers
