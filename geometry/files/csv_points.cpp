// SPDX-License-Identifier: GPL-3.0-or-later
// Points as comma-separated values: the first line names the columns, x y z (or ParaView's Points:0
// Points:1 Points:2) among them; every other column is an attribute.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view around = " \t\r\"";
  const std::size_t first = std::min(text.find_first_not_of(around), text.size());
  const std::size_t last = text.find_last_not_of(around);
  return last == text.npos ? std::string_view() : text.substr(first, last + 1 - first);
}

/// Cuts the text up to the separator off, or all of it.
std::string_view cut(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& path)
      : file_(path.string()), content_(read_text(path)), rest_(content_) {}

  PointSet read() {
    read_header();
    while (!rest_.empty()) read_line();
    PointSet points;
    points.positions.resize(columns_.front().size());
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < points.positions.size(); ++i)
        points.positions[i][axis] = columns_[axes_[axis]][i];
    VertexAttributes attributes;
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (std::ranges::find(axes_, k) == axes_.end())
        attributes[names_[k]] = std::move(columns_[k]);
    take_attributes(std::move(attributes), points);
    return points;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, what));
  }

  std::string_view next_line() {
    ++line_;
    return cut(rest_, '\n');
  }

  void read_header() {
    for (std::string_view line = next_line(); !line.empty();)
      names_.emplace_back(trimmed(cut(line, ',')));
    columns_.resize(names_.size());
    const auto place = [this](std::string_view name) -> std::optional<std::size_t> {
      const auto found = std::ranges::find(names_, name);
      if (found == names_.end()) return std::nullopt;
      return std::size_t(found - names_.begin());
    };
    for (int axis = 0; axis < 3; ++axis) {
      auto at = place(std::string_view("xyz").substr(std::size_t(axis), 1));
      if (!at) at = place(fmt::format("Points:{}", axis));
      if (!at)
        fail(fmt::format("no column '{}' among {}; the first line has to name the columns x, y, z",
                         "xyz"[axis], fmt::join(names_, ", ")));
      axes_[std::size_t(axis)] = *at;
    }
  }

  void read_line() {
    std::string_view line = next_line();
    if (trimmed(line).empty()) return;
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const std::string_view word = trimmed(cut(line, ','));
      double value = 0;
      if (!parse_number(word, value))
        fail(fmt::format("column '{}': '{}': expected a number", names_[k], word));
      columns_[k].push_back(value);
    }
    if (!line.empty()) fail(fmt::format("more than the {} columns named", names_.size()));
  }

  std::string file_, content_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::array<std::size_t, 3> axes_{};
};

PointSet read_csv_points(const std::filesystem::path& path) { return CsvReader(path).read(); }

}  // namespace

FormatRow csv_format() {
  return {.ending = ".csv", .title = "comma-separated values", .read_points = read_csv_points};
}

}  // namespace pellucid::geometry
