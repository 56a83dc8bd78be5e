// SPDX-License-Identifier: GPL-3.0-or-later
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "oit/gl/gl_platform.h"
#include "oit/gl/shared_library.h"

namespace pellucid::oit {
namespace {

[[noreturn]] void fail(const char* what) {
  throw WorkError(
      fmt::format("EGL: {}; accepted with --gl egl: a driver with OpenGL 4.5 core and "
                  "surfaceless contexts",
                  what));
}

class EglPlatform final : public GlPlatform {
 public:
  EglPlatform() {
    display_ = surfaceless_display();
    if (display_ == EGL_NO_DISPLAY || !initialize_(display_, nullptr, nullptr)) fail("no display");
    if (!bind_api_(EGL_OPENGL_API)) fail("no desktop OpenGL");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context_ = create_(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 4.5 core context");
  }
  // The display is shared by all contexts of the process and therefore not terminated.
  ~EglPlatform() override { destroy_(display_, context_); }

  void make_current() override {
    if (!make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      fail("the context cannot be made current without a surface");
  }
  Function entry_point(const char* name) override { return get_(name); }

 private:
  EGLDisplay surfaceless_display() const {
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_("eglGetPlatformDisplayEXT"));
    if (!get_platform_display) fail("no platform displays");
    return get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }

  SharedLibrary library_{"libEGL.so.1"};
  decltype(&eglGetProcAddress) get_ =
      library_.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglInitialize) initialize_ =
      library_.function<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api_ = library_.function<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglCreateContext) create_ =
      library_.function<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_ =
      library_.function<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current_ =
      library_.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlPlatform> make_egl_platform() { return std::make_unique<EglPlatform>(); }

}  // namespace pellucid::oit
