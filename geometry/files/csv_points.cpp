// SPDX-License-Identifier: GPL-3.0-or-later
// Points as separated values. The first line that is no comment ("#", "//") names the columns; what
// separates them is found there: ; tab , or blanks. A byte order mark before it is passed over, and
// quotes around names and values. Positions are the columns x y z, in any case and with a unit, "X
// [m]", or what other programs call them; colours are found as in PLY, and every other column is an
// attribute; one whose first value is no number is text, and left out. Where values are separated
// by
// ";" a decimal comma is read as a point.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/lower_case.h"
#include "core/options/parameters.h"
#include "geometry/files/color_names.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace pellucid::geometry {
namespace {

/// What positions are called, the first found counts: as such; by ParaView; by Fluent.
constexpr std::array<std::string_view, 3> axis_names[] = {
    {"x", "y", "z"},
    {"points:0", "points:1", "points:2"},
    {"points_0", "points_1", "points_2"},
    {"coords:0", "coords:1", "coords:2"},
    {"x-coordinate", "y-coordinate", "z-coordinate"}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view around = " \t\r";
  const std::size_t first = std::min(text.find_first_not_of(around), text.size());
  text.remove_prefix(first);
  text = text.substr(0, text.find_last_not_of(around) + 1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text;
}

/// Cuts the text up to the separator off, or all of it; within quotes none separates. Blanks
/// separate however many they are.
std::string_view cut(std::string_view& text, char separator) {
  std::size_t end = 0;
  for (bool quoted = false; end < text.size() && (quoted || text[end] != separator); ++end)
    if (text[end] == '"') quoted = !quoted;
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (separator == ' ') text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return part;
}

std::vector<std::string_view> all_parts(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  if (separator == ' ') line = trimmed(line);
  while (!line.empty()) parts.push_back(cut(line, separator));
  return parts;
}

/// What parts the names into most columns; commas, when nothing does.
char separator_of(std::string_view line) {
  char best = ',';
  std::size_t most = all_parts(line, best).size();
  for (const char separator : {';', '\t'})
    if (const std::size_t count = all_parts(line, separator).size(); count > most) {
      best = separator;
      most = count;
    }
  return most == 1 && all_parts(line, ' ').size() >= 3 ? ' ' : best;
}

/// In small letters, without a unit in brackets: "X [m]" is "x".
std::string plain(std::string_view name) {
  return lower_case(trimmed(name.substr(0, name.find_first_of("[("))));
}

/// What stands in a name's brackets: of "X [m]" "m".
std::string_view unit_in(std::string_view name) {
  const std::size_t open = name.find_first_of("[(");
  if (open == name.npos) return {};
  name.remove_prefix(open + 1);
  return trimmed(name.substr(0, name.find_first_of("])")));
}

bool is_whole(double value) { return value == std::floor(value); }

/// Whole numbers with one above 1 count in 255ths.
double unit_of(const std::vector<double>& channel) {
  const bool bytes = std::ranges::all_of(channel, is_whole) &&
                     std::ranges::any_of(channel, [](double value) { return value > 1; });
  return bytes ? 255 : 1;
}

class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& path)
      : file_(path.string()), content_(read_text(path)), rest_(without_mark(content_)) {}

  PointSet read() {
    read_header();
    while (!rest_.empty()) read_line();
    PointSet points;
    points.positions.resize(positions_);
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points.positions.size(); ++i)
        points.positions[i][axis] = columns_[axes_[std::size_t(axis)]][i];
    take_attributes(attributes(), points);
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (is_text_[k])
        points.remarks.push_back(fmt::format("column '{}' is text and is left out", names_[k]));
    return points;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, what));
  }

  std::string_view next_line() {
    ++line_;
    return take_line(rest_);
  }

  /// Where the names are those of positions, the columns of x, y and z.
  std::optional<std::array<std::size_t, 3>> find_axes() const {
    std::vector<std::string> names;
    for (const std::string& name : names_) names.push_back(plain(name));
    for (const auto& family : axis_names) {
      std::array<std::size_t, 3> places{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        places[axis] = std::size_t(std::ranges::find(names, family[axis]) - names.begin());
      if (std::ranges::max(places) < names.size()) return places;
    }
    return std::nullopt;
  }

  bool take_names(std::string_view line) {
    separator_ = separator_of(line);
    names_.clear();
    for (const std::string_view name : all_parts(line, separator_))
      names_.emplace_back(trimmed(name));
    const auto axes = find_axes();
    if (axes) axes_ = *axes;
    return axes.has_value();
  }

  /// A comment may hold the names: "//X;Y;Z".
  void read_header() {
    for (bool found = false; !found;) {
      std::string_view line = next_line();
      const bool is_comment = line.starts_with('#') || line.starts_with("//");
      if (is_comment) line.remove_prefix(line.front() == '#' ? 1 : 2);
      found = take_names(line);
      if (!found && !is_comment && !(line.empty() && !rest_.empty()))
        fail(fmt::format("no columns x, y, z among {}; the first line has to name them",
                         fmt::join(names_, ", ")));
      if (!found && rest_.empty()) fail("the file has no line that names the columns x, y, z");
    }
    check_names();
    columns_.resize(names_.size());
    is_text_.assign(names_.size(), false);
  }

  /// Columns of one name would be one; positions are of one unit.
  void check_names() const {
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (std::ranges::count(names_, names_[k]) > 1)
        fail(fmt::format("two columns are called '{}'", names_[k]));
    std::string_view unit;
    for (const std::size_t axis : axes_) {
      const std::string_view own = unit_in(names_[axis]);
      if (!own.empty() && !unit.empty() && own != unit)
        fail(fmt::format("'{}', but another axis is in {}; accepted: one unit for x, y and z",
                         names_[axis], unit));
      if (!own.empty()) unit = own;
    }
  }

  bool parse(std::string_view word, double& value) const {
    if (parse_number(word, value)) return true;
    if (separator_ != ';' || word.find(',') == word.npos) return false;
    std::string with_point(word);
    with_point[with_point.find(',')] = '.';
    return parse_number(with_point, value);
  }

  void read_line() {
    std::string_view line = next_line();
    if (trimmed(line).empty()) return;
    if (separator_ == ' ') line = trimmed(line);
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const std::string_view word = trimmed(cut(line, separator_));
      double value = 0;
      if (is_text_[k]) continue;
      if (parse(word, value))
        columns_[k].push_back(value);
      else if (positions_ == 0 && !is_axis(k) && !word.empty())
        is_text_[k] = true;
      else
        fail(fmt::format("column '{}': '{}': expected a number", names_[k], word));
    }
    if (!trimmed(line).empty()) fail(fmt::format("more than the {} columns named", names_.size()));
    ++positions_;
  }

  VertexAttributes attributes() {
    std::vector<std::string> others;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (!is_axis(k) && !is_text_[k]) others.push_back(names_[k]);
    const auto channels = color_channels(others);
    const auto unit_among = [&](bool alpha) {
      double unit = 1;
      for (std::size_t k = 0; k < names_.size(); ++k)
        if (const auto channel = channels.find(names_[k]); !is_axis(k) && !is_text_[k] &&
                                                           channel != channels.end() &&
                                                           (channel->second == "alpha") == alpha)
          unit = std::max(unit, unit_of(columns_[k]));
      return unit;
    };
    const double of_rgb = unit_among(false), of_alpha = unit_among(true);
    VertexAttributes attributes;
    for (std::size_t k = 0; k < names_.size(); ++k) {
      if (is_axis(k) || is_text_[k]) continue;
      const auto channel = channels.find(names_[k]);
      if (channel != channels.end())
        for (double& value : columns_[k]) value /= channel->second == "alpha" ? of_alpha : of_rgb;
      attributes[channel == channels.end() ? names_[k] : channel->second] = std::move(columns_[k]);
    }
    return attributes;
  }

  bool is_axis(std::size_t column) const { return std::ranges::find(axes_, column) != axes_.end(); }

  std::string file_, content_;
  std::string_view rest_;
  std::size_t line_ = 0;
  char separator_ = ',';
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::vector<bool> is_text_;  // columns whose first value is no number
  std::size_t positions_ = 0;  // read so far
  std::array<std::size_t, 3> axes_{};
};

PointSet read_csv_points(const std::filesystem::path& path) { return CsvReader(path).read(); }

}  // namespace

FormatRow csv_format() {
  return {.ending = ".csv",
          .title = "separated values",
          .traps = "any of , ; tab and blanks; x, y, z in any case and with a unit, or Points:0 …",
          .read_points = read_csv_points};
}

}  // namespace pellucid::geometry
