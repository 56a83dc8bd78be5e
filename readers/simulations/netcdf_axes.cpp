// SPDX-License-Identifier: GPL-3.0-or-later
// Eaton et al., NetCDF Climate and Forecast (CF) Metadata Conventions 1.11, Sect. 4: "the axis
// attribute", 4.1 and 4.2 units of latitude and longitude, 4.3 of vertical coordinates. Their order
// is recommended (Sect. 2.4), and no more.

#include "readers/simulations/netcdf_axes.h"

#include <vtk_netcdf.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "core/options/lower_case.h"

namespace pellucid::readers {
namespace {

struct Word {
  std::string_view text;
  int axis;
};

// Standard names, units and, where a file says nothing else, usual names: in small letters.
constexpr Word words[] = {{"x", 0},
                          {"lon", 0},
                          {"longitude", 0},
                          {"grid_longitude", 0},
                          {"projection_x_coordinate", 0},
                          {"degrees_east", 0},
                          {"degree_east", 0},
                          {"degrees_e", 0},
                          {"degree_e", 0},
                          {"degreese", 0},
                          {"degreee", 0},
                          {"y", 1},
                          {"lat", 1},
                          {"latitude", 1},
                          {"grid_latitude", 1},
                          {"projection_y_coordinate", 1},
                          {"degrees_north", 1},
                          {"degree_north", 1},
                          {"degrees_n", 1},
                          {"degree_n", 1},
                          {"degreesn", 1},
                          {"degreen", 1},
                          {"z", 2},
                          {"lev", 2},
                          {"level", 2},
                          {"layer", 2},
                          {"sigma_level", 2},
                          {"depth", 2},
                          {"height", 2},
                          {"altitude", 2},
                          {"air_pressure", 2},
                          {"pa", 2},
                          {"hpa", 2},
                          {"bar", 2},
                          {"mbar", 2},
                          {"millibar", 2},
                          {"millibars", 2},
                          {"decibar", 2},
                          {"dbar", 2}};

std::optional<int> axis_of_word(const std::string& text) {
  const auto* found = std::ranges::find(words, lower_case(text), &Word::text);
  return found == std::end(words) ? std::nullopt : std::optional(found->axis);
}

std::optional<int> axis_of_standard_name(const std::string& name) {
  const bool is_level = name.ends_with("_coordinate") &&
                        (name.starts_with("atmosphere_") || name.starts_with("ocean_"));
  if (is_level || name.starts_with("height_above_")) return 2;
  return axis_of_word(name);
}

/// What the coordinate variable of the dimension's name says.
std::optional<int> axis_of_attributes(int file, const char* name) {
  int variable = 0;
  if (nc_inq_varid(file, name, &variable) != NC_NOERR) return std::nullopt;
  const std::string axis = text_attribute(file, variable, "axis");
  if (axis.size() == 1)
    if (const auto found = axis_of_word(axis)) return found;
  if (const auto axis_of = axis_of_standard_name(text_attribute(file, variable, "standard_name")))
    return axis_of;
  if (const auto axis_of = axis_of_word(text_attribute(file, variable, "units"))) return axis_of;
  if (!text_attribute(file, variable, "positive").empty()) return 2;
  return std::nullopt;
}

std::optional<int> axis_of_dimension(int file, int dimension) {
  char name[NC_MAX_NAME + 1] = {};
  if (nc_inq_dimname(file, dimension, name) != NC_NOERR) return std::nullopt;
  const auto said = axis_of_attributes(file, name);
  return said ? said : axis_of_word(name);
}

}  // namespace

std::string text_attribute(int file, int variable, const char* name) {
  std::size_t length = 0;
  nc_type type = NC_NAT;
  if (nc_inq_att(file, variable, name, &type, &length) != NC_NOERR || type != NC_CHAR) return {};
  std::string text(length, '\0');
  if (nc_get_att_text(file, variable, name, text.data()) != NC_NOERR) return {};
  return text.substr(0, text.find('\0'));
}

std::string dimension_of_listed_places(int file, int variable) {
  std::map<int, std::set<int>> axes_along;  // a dimension
  std::istringstream words(text_attribute(file, variable, "coordinates"));
  for (std::string name; words >> name;) {
    int id = 0, count = 0, dimension = 0;
    if (nc_inq_varid(file, name.c_str(), &id) != NC_NOERR ||
        nc_inq_varndims(file, id, &count) != NC_NOERR || count != 1)
      continue;
    nc_inq_vardimid(file, id, &dimension);
    if (const auto axis = axis_of_attributes(file, name.c_str()))
      axes_along[dimension].insert(*axis);
  }
  for (const auto& [dimension, axes] : axes_along) {
    char name[NC_MAX_NAME + 1] = {};
    if (axes.contains(0) && axes.contains(1) && nc_inq_dimname(file, dimension, name) == NC_NOERR)
      return name;
  }
  return {};
}

AxisOrder axis_order(int file, std::span<const int> dimensions) {
  constexpr AxisOrder by_place{0, 1, 2};
  AxisOrder order{-1, -1, -1};
  std::array<bool, 3> taken{};
  for (std::size_t i = 0; i < std::min<std::size_t>(dimensions.size(), 3); ++i)
    if (const auto axis = axis_of_dimension(file, dimensions[i])) {
      if (taken[std::size_t(*axis)]) return by_place;
      order[i] = *axis;
      taken[std::size_t(*axis)] = true;
    }
  for (std::size_t i = 0; i < 3; ++i)
    if (order[i] < 0 && !taken[i]) order[i] = int(i), taken[i] = true;
  for (int& axis : order)
    if (axis < 0) {
      const auto place = std::ranges::find(taken, false);
      axis = int(place - taken.begin());
      *place = true;
    }
  return order;
}

}  // namespace pellucid::readers
