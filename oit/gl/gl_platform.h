// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

namespace pellucid::oit {

/// A way to get an OpenGL context without a window. Its library is loaded when it is made, so that
/// a command that draws nothing by OpenGL never loads a driver.
class GlPlatform {
 public:
  using Function = void (*)();

  virtual ~GlPlatform() = default;
  virtual void make_current() = 0;
  virtual Function entry_point(const char* name) = 0;
};

/// Mesa's off-screen software context, 4.5 core, no multisampling. Throws WorkError.
std::unique_ptr<GlPlatform> make_osmesa_platform();

/// EGL without a surface: the graphics card where there is one, llvmpipe elsewhere. Throws
/// WorkError.
std::unique_ptr<GlPlatform> make_egl_platform();

}  // namespace pellucid::oit
