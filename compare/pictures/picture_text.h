// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace pellucid::compare {

/// A PictureText is what a picture says of itself in its file: names and texts, in UTF-8.
using PictureText = std::vector<std::pair<std::string, std::string>>;

/// A PictureForm says how a picture is written.
struct PictureForm {
  PictureText text = {};
  /// Its colours are premultiplied by A, over no background: a .png gets straight colours and an
  /// alpha channel, which it has of no other picture.
  bool is_premultiplied = false;
};

/// A PictureOrigin is what a picture was made of.
struct PictureOrigin {
  std::string scene;   // its name, without folders: the same picture is the same file anywhere
  std::string camera;  // see scene::camera_text()
  Vec3 background;     // red, green, blue
  std::string call;    // of the method
};

/// Returns how such a picture is written, with what it says of itself:
///
///     Software   "pellucid 1.0 (commit)"
///     Scene      its name
///     Method     "fourier:bands=5"
///     Camera     as --camera takes it
///     Values     what the numbers are
PictureForm form_of_picture(const PictureOrigin& origin, bool is_premultiplied = false);

/// Returns it for a picture of the scene by `call`.
PictureForm form_of_picture(const scene::Scene& scene, const std::string& call,
                            bool is_premultiplied = false);

}  // namespace pellucid::compare
