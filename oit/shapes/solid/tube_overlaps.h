// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "scene/view/radii.h"

namespace pellucid::oit {

/// A SegmentPair is two segments of a line, counted from 0, the smaller first.
using SegmentPair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns the pairs of a line's segments that may come nearer to each other than both radii there:
/// all whose round tubes overlap, and few others. Of more than `most` pairs it returns one more
/// than that. It takes time in proportion to the line and the pairs where the line does not fill
/// space.
std::vector<SegmentPair> overlapping_segments(std::span<const Vec3> line, scene::RadiusSpan radius,
                                              std::size_t most);

}  // namespace pellucid::oit
