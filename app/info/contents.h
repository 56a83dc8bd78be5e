// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace pellucid::app {

/// An ArrayContents is what a named array holds: `count` tuples of as many numbers as there are
/// ranges.
struct ArrayContents {
  std::string name;
  std::string at;                // what has a tuple each: "point", "cell", "face", "grid", "pixel"
  std::string type;              // of a number, as C++ names it
  std::uint64_t count = 0;       // of tuples
  std::vector<Vec2> ranges;      // of each component's finite values; (inf, -inf) of none
  std::uint64_t not_finite = 0;  // of all numbers
};

/// A FileContents is what `info` tells of a file.
struct FileContents {
  std::string kind;            // "triangles", "image", "scene", …
  std::string title;           // of the format
  std::optional<Box3> bounds;  // world
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  std::vector<ArrayContents> arrays;
  std::vector<double> times;
  nlohmann::ordered_json more = nlohmann::ordered_json::object();  // what this kind alone has
};

/// Collects the ranges of an array, number by number.
class RangeCollector {
 public:
  explicit RangeCollector(std::size_t components) : ranges_(components, none) {}

  void add(std::size_t component, double value) {
    Vec2& range = ranges_[component];
    if (!std::isfinite(value)) {
      ++not_finite_;
      return;
    }
    if (value < range.x) range.x = value;
    if (value > range.y) range.y = value;
  }
  ArrayContents contents(std::string name, std::string at, std::string type,
                         std::uint64_t count) const {
    return {std::move(name), std::move(at), std::move(type), count, ranges_, not_finite_};
  }

 private:
  inline static const Vec2 none{INFINITY, -INFINITY};
  std::vector<Vec2> ranges_;
  std::uint64_t not_finite_ = 0;
};

/// Returns the numbers of a vector as JSON; null for those that are not finite.
nlohmann::ordered_json json_of(const Vec3& v);

/// Returns the contents as JSON; what is not there has no key.
nlohmann::ordered_json to_json(const FileContents& contents);

/// Prints them for people, a line each.
void print(const FileContents& contents);

}  // namespace pellucid::app
