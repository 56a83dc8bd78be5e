// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pellucid::integrators {

/// Facet holds the numbers of a triangle's corners.
using Facet = std::array<std::uint32_t, 3>;

/// Appends the parts of a facet whose sides have these middles, or none: two, three or four parts.
/// Of a quadrilateral, which two middles leave, `is_shorter(a, b, c, d)` says whether the diagonal
/// from a to b is the shorter one.
template <class IsShorter>
void append_parts(const Facet& facet, const std::array<std::optional<std::uint32_t>, 3>& middles,
                  const IsShorter& is_shorter, std::vector<Facet>& parts) {
  const auto count = std::size_t(middles[0].has_value()) + std::size_t(middles[1].has_value()) +
                     std::size_t(middles[2].has_value());
  if (count == 3) {
    const std::uint32_t a = *middles[0], b = *middles[1], c = *middles[2];
    parts.insert(parts.end(), {{facet[0], a, c}, {a, facet[1], b}, {c, b, facet[2]}, {a, b, c}});
    return;
  }
  // Turned so that the first side is halved, and of two the second one, too.
  std::size_t k = 0;
  while (!middles[k] || (count == 2 && !middles[(k + 1) % 3])) ++k;
  const std::uint32_t v0 = facet[k], v1 = facet[(k + 1) % 3], v2 = facet[(k + 2) % 3];
  const std::uint32_t a = *middles[k];
  if (count == 1) {
    parts.insert(parts.end(), {{v0, a, v2}, {a, v1, v2}});
    return;
  }
  const std::uint32_t b = *middles[(k + 1) % 3];
  parts.push_back({a, v1, b});
  if (is_shorter(a, v2, v0, b))
    parts.insert(parts.end(), {{v0, a, v2}, {a, b, v2}});
  else
    parts.insert(parts.end(), {{v0, a, b}, {v0, b, v2}});
}

}  // namespace pellucid::integrators
