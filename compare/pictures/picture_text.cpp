// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/picture_text.h"

#include <fmt/format.h>

#include "core/machine/build_info.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {

PictureForm form_of_picture(const PictureOrigin& origin, bool is_premultiplied) {
  const Vec3& b = origin.background;
  const std::string color =
      is_premultiplied ? "colour premultiplied by A, without a background"
                       : fmt::format("colour over the background {}, {}, {}", b.x, b.y, b.z);
  return {{{"Software", fmt::format("pellucid {} ({})", build_version, build_commit)},
           {"Scene", origin.scene},
           {"Method", origin.call},
           {"Camera", origin.camera},
           {"Values",
            "display values (sRGB), blended as they stand; " + color + "; A = 1 - transmittance"}},
          is_premultiplied};
}

PictureForm form_of_picture(const scene::Scene& scene, const std::string& call,
                            bool is_premultiplied) {
  return form_of_picture({scene.name, scene::camera_text(scene.camera), scene.background, call},
                         is_premultiplied);
}

}  // namespace pellucid::compare
