// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/picture_text.h"

#include <fmt/format.h>

#include "core/machine/build_info.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {
namespace {

std::pair<std::string, std::string> software() {
  return {"Software", fmt::format("pellucid {} ({})", build_version, build_commit)};
}

constexpr const char* blended = "display values (sRGB), blended as they stand; ";

/// A .png of colours over a background has no alpha: a viewer would blend them a second time.
void describe_values(const std::optional<Vec3>& background, PictureForm& form) {
  form.is_premultiplied = !background;
  if (background) {
    const std::string color = fmt::format("{}colour over the background {}, {}, {}", blended,
                                          background->x, background->y, background->z);
    form.exr_values = color + "; A = 1 - transmittance";
    form.png_values = color + "; in 8 bits, without A";
    return;
  }
  form.exr_values = fmt::format(
      "{}colour premultiplied by A, without a background; A = 1 - transmittance", blended);
  form.png_values = fmt::format(
      "{}straight colour, not multiplied by A, without a background; A = 1 - transmittance; in 8 "
      "bits",
      blended);
}

}  // namespace

PictureForm form_of_picture(const PictureOrigin& origin) {
  PictureForm form;
  form.text = {software(), {"Scene", origin.scene}, {"Method", origin.method}};
  if (!origin.opacities.empty()) form.text.emplace_back("Opacities", origin.opacities);
  form.text.emplace_back("Camera", origin.camera);
  describe_values(origin.background, form);
  return form;
}

PictureForm form_of_picture(const scene::Scene& scene, const PictureCall& call) {
  return form_of_picture({scene.name, scene::camera_text(scene.camera),
                          call.without_background ? std::nullopt : std::optional(scene.background),
                          call.method, call.opacities});
}

PictureForm form_of_map(const std::string& values) { return {{software()}, values, values}; }

PictureText text_beside(const PictureForm& picture, const std::string& values) {
  PictureText text = picture.text;
  text.emplace_back("Values", values);
  return text;
}

PictureText text_of_exr(const PictureForm& form) { return text_beside(form, form.exr_values); }

PictureText text_of_png(const PictureForm& form) { return text_beside(form, form.png_values); }

}  // namespace pellucid::compare
