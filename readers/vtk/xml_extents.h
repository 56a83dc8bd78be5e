// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "readers/vtk/xml_tags.h"

namespace pellucid::readers {

/// An Extent is a part of a grid along indices: the first and the last sample along each axis.
struct Extent {
  std::array<std::int64_t, 6> ends{};

  std::int64_t first(std::size_t axis) const { return ends[2 * axis]; }
  std::int64_t last(std::size_t axis) const { return ends[2 * axis + 1]; }
  bool is_empty() const { return first(0) > last(0) || first(1) > last(1) || first(2) > last(2); }
};

/// Returns the extent that a tag's attribute says, whose form check_xml() has seen; nothing where
/// it has no such attribute.
std::optional<Extent> extent_of(const XmlTag& tag, std::string_view attribute);

/// Throws InputError where the pieces of a structured grid in one file do not hold each cell of its
/// WholeExtent once (or, without values of cells, each sample): VTK would leave zeros.
void check_extents(std::span<const XmlTag> tags, const std::filesystem::path& path);

}  // namespace pellucid::readers
