// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace pellucid::compare {

/// A PictureText is what a picture says of itself in its file: names and texts, in UTF-8.
using PictureText = std::vector<std::pair<std::string, std::string>>;

/// A PictureForm says how a picture is written, and what its file says of it.
struct PictureForm {
  PictureText text;        // but what the numbers are
  std::string exr_values;  // what the numbers are, of an .exr
  std::string png_values;  // the same of a .png
  /// Its colours are premultiplied by A, over no background: a .png gets straight colours and an
  /// alpha channel, which it has of no other picture.
  bool is_premultiplied = false;
};

/// A PictureCall is what drew a picture of a scene.
struct PictureCall {
  std::string method;       // its call
  std::string opacities;    // the call that chose the opacities before; empty: none did
  bool without_background;  // colours are premultiplied by A
};

/// A PictureOrigin is what a picture was made of.
struct PictureOrigin {
  std::string scene;               // its name, without folders: the same picture is the same file
  std::string camera;              // see scene::camera_text()
  std::optional<Vec3> background;  // red, green, blue; nothing: colours are premultiplied by A
  std::string method;              // its call
  std::string opacities;           // see PictureCall
};

/// Returns how such a picture is written, with what it says of itself:
///
///     Software   "pellucid 1.0 (commit)"
///     Scene      its name
///     Method     "fourier:bands=5"
///     Opacities  the call that chose them, where one did
///     Camera     as --camera takes it
///     Values     what the numbers are, in the file's format
///
/// A picture of a part of the scene's primitives says "Part" besides: see DeepOutputs.
PictureForm form_of_picture(const PictureOrigin& origin);

/// Returns it for a picture of the scene.
PictureForm form_of_picture(const scene::Scene& scene, const PictureCall& call);

/// Returns how a picture is written that is none of a scene, such as a map of errors: `values` says
/// what its numbers are.
PictureForm form_of_map(const std::string& values);

/// Returns what a file of numbers beside the picture, such as those of layers, says of itself.
PictureText text_beside(const PictureForm& picture, const std::string& values);

/// Returns all that the picture's file says of it.
///@{
PictureText text_of_exr(const PictureForm& form);
PictureText text_of_png(const PictureForm& form);
///@}

}  // namespace pellucid::compare
