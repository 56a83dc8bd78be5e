// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace pellucid::groundtruth {

/// A Crossing is where a ray crosses a primitive in front of the eye.
struct Crossing {
  double depth;             // view depth, units (see ViewFrame)
  double u, v;              // where on the primitive: a matter of its kind of geometry
  std::uint32_t object;     // index in Scene::objects
  std::uint32_t primitive;  // see Scene

  /// Orders crossings front to back, those of equal depth by object, then by primitive.
  friend bool operator<(const Crossing& p, const Crossing& q) {
    if (p.depth != q.depth) return p.depth < q.depth;
    if (p.object != q.object) return p.object < q.object;
    if (p.primitive != q.primitive) return p.primitive < q.primitive;
    return p.v < q.v;  // a solid is entered (v < 0) before it is left
  }
  friend bool operator==(const Crossing&, const Crossing&) = default;
};

/// A Fragment is a crossing's colour (lit, not premultiplied) and opacity, in [0, 1].
struct Fragment {
  Vec3 color;
  double opacity;
};

}  // namespace pellucid::groundtruth
