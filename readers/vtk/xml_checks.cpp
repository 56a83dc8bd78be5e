// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/options/parameters.h"
#include "readers/vtk/vtk_formats.h"
#include "readers/vtk/xml_extents.h"
#include "readers/vtk/xml_pieces.h"
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
      refuse_attribute(path, tag, row.attribute, found->second, accepted_by(row));
  }
  for (const WordsRow& row : words_table)
    if (const auto found = tag.attributes.find(row.attribute);
        found != tag.attributes.end() &&
        std::ranges::find(row.accepted, found->second) == row.accepted.end())
      refuse_attribute(path, tag, row.attribute, found->second,
                       fmt::format("{}", fmt::join(row.accepted, ", ")));
}

bool is_structured(std::string_view ending) {
  return ending == ".vti" || ending == ".vtr" || ending == ".vts";
}

/// `declared`: by the file of pieces that names this one, which may hold less than it says; else
/// none.
void check_file(const Path& path, const DeclaredWidths* declared, int depth) {
  constexpr int deepest = 4;  // blocks of pieces of blocks; a file may name itself
  const VtkFormat* const format = vtk_format(path);
  std::error_code code;
  if (depth > deepest || !format || !is_xml(*format)) return;
  if (!std::filesystem::is_regular_file(path, code)) return;  // VTK says so
  const std::vector<XmlTag> tags = xml_tags_before_data(path);
  for (const XmlTag& tag : tags) check_attributes(tag, path);
  if (is_structured(format->ending) && !declared) check_extents(tags, path);
  if (declared) declared->check_piece(tags, path);
  if (format->beside != Beside::named) return check_pieces(tags, path);
  const DeclaredWidths own(tags, path);
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
