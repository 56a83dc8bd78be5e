// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/scalar_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "geometry/files/color_names.h"

namespace pellucid::geometry {
namespace {

using Names = std::set<std::string_view>;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& name,
                         std::string_view why) {
  throw InputError(fmt::format("{}: the scalar '{}' cannot be written: {}; accepted: another name",
                               path.string(), name, why));
}

/// No format has names of no length, or of characters that are none.
void check_characters(const std::filesystem::path& path, const std::string& name) {
  const auto is_control = [](char c) { return std::uint8_t(c) < 0x20 || c == 0x7f; };
  if (name.empty()) refuse(path, name, "its name is empty");
  if (std::ranges::any_of(name, is_control))
    refuse(path, name, "its name has a line's end, a tab or another control character");
}

void check_taken(const std::filesystem::path& path, const std::string& name, const Names& taken) {
  if (taken.contains(name)) refuse(path, name, "the name means something else in the file");
}

bool has_all(const Vertices& vertices, std::initializer_list<const char*> names) {
  return std::ranges::all_of(names,
                             [&](const char* name) { return vertices.scalars.contains(name); });
}

/// What readers of any format take for something else than a scalar.
Names taken_names(const Vertices& vertices) {
  Names taken{"importance"};
  if (!vertices.normals.empty() || has_all(vertices, {"nx", "ny", "nz"}))
    taken.insert({"nx", "ny", "nz"});
  if (!vertices.colors.empty() || has_all(vertices, {"red", "green", "blue"}))
    taken.insert({"red", "green", "blue", "alpha"});
  return taken;
}

}  // namespace

void check_ply_names(const std::filesystem::path& path, const Vertices& vertices,
                     const char* also_taken) {
  Names taken = taken_names(vertices);
  taken.insert({"x", "y", "z", also_taken});
  std::vector<std::string> names;  // in the file's order
  if (!vertices.colors.empty()) names = {"red", "green", "blue", "alpha"};
  for (const auto& [name, values] : vertices.scalars) names.push_back(name);
  const auto channels = color_channels(names);
  for (const auto& [name, values] : vertices.scalars) {
    check_characters(path, name);
    if (name.find(' ') != name.npos) refuse(path, name, "names have no blanks in a .ply file");
    check_taken(path, name, taken);
    if (channels.contains(name)) refuse(path, name, "it would be read as a colour");
  }
}

void check_vtk_names(const std::filesystem::path& path, const Vertices& vertices) {
  Names taken = taken_names(vertices);
  taken.insert({"RGBA", "Normals", "vtkGhostType"});
  for (const auto& [name, values] : vertices.scalars) {
    check_characters(path, name);
    check_taken(path, name, taken);
  }
}

}  // namespace pellucid::geometry
