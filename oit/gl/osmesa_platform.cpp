// SPDX-License-Identifier: GPL-3.0-or-later
// Mesa comes without OSMesa from 25.1 on: a program that was built there asks EGL for the same
// driver.
#if __has_include(<GL/osmesa.h>)
#include <GL/osmesa.h>
#define PELLUCID_HAS_OSMESA 1
#else
#define PELLUCID_HAS_OSMESA 0
#endif

#include "oit/gl/egl_devices.h"
#include "oit/gl/shared_library.h"

namespace pellucid::oit {

bool has_osmesa() { return PELLUCID_HAS_OSMESA; }

#if PELLUCID_HAS_OSMESA
namespace {

class OsmesaPlatform final : public GlPlatform {
 public:
  OsmesaPlatform() {
    // A forward-looking profile has no multisampling unless a framebuffer asks for it.
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_STENCIL_BITS,
                              0,
                              0};
    context_ = create_(attributes, nullptr);
    if (!context_) throw WorkError("OSMesa offers no OpenGL 4.5 core context");
  }
  ~OsmesaPlatform() override { destroy_(context_); }

  void make_current() override {
    if (!make_current_(context_, pixel_, GL_UNSIGNED_BYTE, 1, 1))
      throw WorkError("OSMesaMakeCurrent failed");
  }
  Function entry_point(const char* name) override { return get_(name); }

 private:
  SharedLibrary library_{"libOSMesa.so.8"};
  decltype(&OSMesaCreateContextAttribs) create_ =
      library_.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaDestroyContext) destroy_ =
      library_.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(&OSMesaMakeCurrent) make_current_ =
      library_.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetProcAddress) get_ =
      library_.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
  OSMesaContext context_ = nullptr;
  unsigned char pixel_[4] = {};  // OSMesa wants a default framebuffer; nothing is drawn into it
};

}  // namespace

std::unique_ptr<GlPlatform> make_osmesa_platform() { return std::make_unique<OsmesaPlatform>(); }
#else
std::unique_ptr<GlPlatform> make_osmesa_platform() { return make_egl_platform("egl:software"); }
#endif

}  // namespace pellucid::oit
