// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/ply/ply_columns.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/files/pages.h"
#include "geometry/files/color_names.h"

namespace pellucid::geometry::ply {
namespace {

/// 8- and 16-bit colours count in steps of 1/255 and 1/65535; anything else is used as it stands.
double color_scale(Type type) {
  if (type == Type::uint8) return 255;
  if (type == Type::uint16) return 65535;
  return 1;
}

}  // namespace

void check_count(const Reader& reader, const Element& element) {
  if (!element.properties.empty() &&
      element.count > reader.bytes_left() / element.properties.size())
    throw InputError(fmt::format("{}: the header declares {} × '{}', but only {} bytes follow",
                                 reader.where(), element.count, element.name, reader.bytes_left()));
}

std::uint64_t list_length(Reader& reader, const Property& property) {
  constexpr double most = 1e18;
  const double length = reader.next(property.count_type);
  if (!(length >= 0 && length < most) || length != std::floor(length))
    throw InputError(
        fmt::format("{}: '{}': a list of {} values; accepted: a whole number from 0 on",
                    reader.where(), property.name, length));
  return std::uint64_t(length);
}

void skip(Reader& reader, const Property& property) {
  const std::uint64_t count = property.is_list ? list_length(reader, property) : 1;
  for (std::uint64_t i = 0; i < count; ++i) reader.next(property.type);
}

void skip(Reader& reader, const Element& element) {
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const Property& property : element.properties) skip(reader, property);
}

Columns::Columns(const Element& element) {
  std::vector<std::string> names;
  for (const Property& property : element.properties)
    if (!property.is_list) names.push_back(property.name);
  const auto channels = color_channels(names);
  for (const Property& property : element.properties) {
    const auto channel = channels.find(property.name);
    const bool is_color = channel != channels.end();
    columns_.push_back(
        {property.is_list ? nullptr : &values_[is_color ? channel->second : property.name],
         is_color ? color_scale(property.type) : 1});
    if (columns_.back().values) reserve_in_huge_pages(*columns_.back().values, element.count);
  }
}

void Columns::read(Reader& reader, const Property& property, std::size_t number) {
  columns_[number].values->push_back(reader.next(property.type) / columns_[number].scale);
}

VertexAttributes read_columns(Reader& reader, const Element& element) {
  Columns columns(element);
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& property = element.properties[k];
      if (property.is_list)
        skip(reader, property);
      else
        columns.read(reader, property, k);
    }
  return columns.take();
}

}  // namespace pellucid::geometry::ply
