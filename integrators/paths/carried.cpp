// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/carried.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::integrators {

void carry(const fields::Attributes& attributes, std::span<const Vec3> places,
           geometry::Vertices& vertices) {
  for (std::size_t k = 0; k < attributes.names().size(); ++k) {
    const std::string& name = attributes.names()[k];
    const auto [scalar, is_new] = vertices.scalars.try_emplace(name);
    if (!is_new)
      throw InputError(fmt::format(
          "scalar '{0}': what is integrated has one of its own; accepted: the file's as point:{0} "
          "or cell:{0}",
          name));
    scalar->second = attributes.values(k, places, vertices.scalars.at("time"));
  }
}

}  // namespace pellucid::integrators
