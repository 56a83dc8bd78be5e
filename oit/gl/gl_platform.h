// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

namespace pellucid::oit {

/// A GlPlatform is a way to get an OpenGL context without a window. Its library is loaded when it
/// is made, so that a command that draws nothing by OpenGL never loads a driver.
class GlPlatform {
 public:
  using Function = void (*)();

  virtual ~GlPlatform() = default;
  virtual void make_current() = 0;
  virtual Function entry_point(const char* name) = 0;
};

/// Returns whether the program was built with OSMesa.
bool has_osmesa();

/// Makes Mesa's software context, 4.5 core, no multisampling: OSMesa's, or without it that of
/// EGL without a surface, on the same driver. Throws WorkError when its library cannot be loaded or
/// offers no such context.
std::unique_ptr<GlPlatform> make_osmesa_platform();

/// Makes a 4.5 core context of EGL without a surface: the graphics card's where there is one,
/// llvmpipe's elsewhere. Throws WorkError when its library cannot be loaded or offers no such
/// context.
std::unique_ptr<GlPlatform> make_egl_platform();

}  // namespace pellucid::oit
