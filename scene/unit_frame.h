#pragma once

#include "scene/scene.h"

namespace pellucid {

/// The frame in which pictures are computed: the scene's box moved to the origin and scaled by a
/// power of two (exactly, but for underflow) so that its largest half side lies in (1/2, 1]. It
/// makes results independent of the scene's scale, and floats as fine as they can be.
struct UnitFrame {
  Vec3 center{0};
  double scale = 1;  // unit lengths per world unit

  Vec3 from_world(const Vec3& x) const { return (x - center) * scale; }
};

/// A scene of one single point has scale 1.
UnitFrame unit_frame(const Scene& scene);

}  // namespace pellucid
