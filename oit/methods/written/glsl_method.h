// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// GlslOptions are those of the method glsl.
struct GlslOptions {
  std::string file;        // of format "pellucid-glsl-method"
  std::string parameters;  // "NAME=VALUE NAME=VALUE": of the file's own

  bool operator==(const GlslOptions&) const = default;
};
/// Returns the table of these options.
const OptionTable<GlslOptions>& glsl_options();

/// A method that a file describes: textures of the picture's size, and passes with fragment shaders
/// written against oit/shapes/fragment.glsl and oit/stage/composite.glsl, as the methods of this
/// room are. See docs/glsl-method.md.
///
/// It promises nothing, since it is what its file says, and is not among oit_methods(): it draws
/// nothing without a file. Throws InputError for a file that is none, a parameter that it does not
/// have, and a shader that does not compile, with the compiler's words.
const scene::MethodRow& glsl_method();

}  // namespace pellucid::oit
