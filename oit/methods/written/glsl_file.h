// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/options/parameters.h"
#include "oit/gl/pass.h"

namespace pellucid::oit {

/// A GlslFormat is a format of the textures of a written method, as OpenGL, GLSL's layouts and
/// GLSL's types name it.
struct GlslFormat {
  std::string_view name;  // "rgba32f"
  GLenum format;
  std::string_view type;  // of a texel that a pass draws: "vec4"
  bool whole;             // unsigned integers; they are not blended
};

/// A GlslTexture is as large as the picture; the passes of a method share it.
struct GlslTexture {
  std::string name;
  const GlslFormat* format = nullptr;
  double clear = 0;        // every component at the start of a picture
  int layers = 0;          // of an array; 0: a plain texture
  std::string layers_are;  // the parameter that tells them, or empty
};

/// A GlslParameter is a number that the shaders find as a uniform of its name: int where it is
/// whole, else float.
struct GlslParameter {
  std::string name, default_value, unit, help;
  double min, max;
  bool whole = false;
};

/// A GlslPass draws the scene's fragments, or every pixel once. Numbers are those of textures in
/// the method's list.
struct GlslPass {
  std::string step;
  bool screen = false;
  std::filesystem::path file;  // of the text, for messages
  std::string text;
  std::vector<std::pair<std::size_t, Blend>> into;  // none of a screen pass: the picture
  std::vector<std::size_t> reads, images;
};

/// A WrittenMethod is a method of order-independent transparency that a file describes.
struct WrittenMethod {
  std::string title, citation;
  std::vector<GlslParameter> parameters;
  std::vector<GlslTexture> textures;
  std::vector<GlslPass> passes;

  /// Returns the parameters as a method's are. Valid as long as this.
  std::vector<ParameterSpec> specs() const;
};

/// Reads a file of format "pellucid-glsl-method" (docs/glsl-method.md) and the texts that it names,
/// from its folder on. Throws InputError that names the file and the place in it.
WrittenMethod read_glsl_method(const std::filesystem::path& path);

}  // namespace pellucid::oit
