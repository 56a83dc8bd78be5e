// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
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

bool is_structured(std::string_view ending) {
  return ending == ".vti" || ending == ".vtr" || ending == ".vts";
}

/// `in_parallel`: what a file of pieces names, which may be less than it says.
void check_file(const Path& path, bool in_parallel, int depth) {
  constexpr int deepest = 4;  // blocks of pieces of blocks; a file may name itself
  const VtkFormat* const format = vtk_format(path);
  std::error_code code;
  if (depth > deepest || !format || !is_xml(*format)) return;
  if (!std::filesystem::is_regular_file(path, code)) return;  // VTK says so
  const std::vector<XmlTag> tags = xml_tags_before_data(path);
  for (const XmlTag& tag : tags) check_attributes(tag, path);
  if (is_structured(format->ending) && !in_parallel) check_pieces(tags, path);
  if (format->beside != Beside::named) return;
  const bool names_pieces = format->ending.starts_with(".pvt");
  for (const XmlTag& tag : tags)
    for (const char* key : {"file", "Source"})
      if (const auto name = tag.attributes.find(key); name != tag.attributes.end())
        check_file(path.parent_path() / name->second, names_pieces, depth + 1);
}

}  // namespace

bool is_xml(const VtkFormat& format) {
  const std::string_view ending = format.ending;
  return (ending.starts_with(".vt") || ending.starts_with(".pvt")) && ending != ".vtk" &&
         ending != ".vtkhdf";
}

void check_xml(const Path& path) { check_file(path, false, 0); }

}  // namespace pellucid::readers
