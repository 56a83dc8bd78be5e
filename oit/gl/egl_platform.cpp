// SPDX-License-Identifier: GPL-3.0-or-later
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "oit/gl/egl_devices.h"
#include "oit/gl/shared_library.h"

namespace pellucid::oit {
namespace {

[[noreturn]] void fail(std::string_view what) {
  throw WorkError(
      fmt::format("EGL: {}; accepted with --gl egl: a driver with OpenGL 4.5 core and contexts "
                  "without a surface; --gl egl:software and --gl osmesa need no graphics card",
                  what));
}

/// EGL's functions that are called here. Those of extensions are null where there is none.
struct Egl {
  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(get(name));
  }

  SharedLibrary library{"libEGL.so.1"};
  decltype(&eglGetProcAddress) get =
      library.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglInitialize) initialize = library.function<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = library.function<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglCreateContext) create =
      library.function<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy =
      library.function<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current =
      library.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC query_devices =
      extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  PFNEGLQUERYDEVICESTRINGEXTPROC device_string =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
};

class EglPlatform final : public GlPlatform {
 public:
  /// On the device, or on EGL's display without a surface.
  EglPlatform(Egl egl, EGLDeviceEXT device) : egl_(std::move(egl)) {
    if (!egl_.platform_display) fail("no platform displays");
    display_ =
        device ? egl_.platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr)
               : egl_.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr))
      fail("no display");
    if (!egl_.bind_api(EGL_OPENGL_API)) fail("no desktop OpenGL");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context_ = egl_.create(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 4.5 core context");
  }
  // The display is shared by all contexts of the process and therefore not terminated.
  ~EglPlatform() override { egl_.destroy(display_, context_); }

  void make_current() override {
    if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      fail("the context cannot be made current without a surface");
  }
  Function entry_point(const char* name) override { return egl_.get(name); }

 private:
  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

std::vector<EGLDeviceEXT> handles_of(const Egl& egl) {
  EGLint count = 0;
  if (!egl.query_devices || !egl.query_devices(0, nullptr, &count)) return {};
  std::vector<EGLDeviceEXT> handles(std::size_t(std::max(count, 0)));
  if (!egl.query_devices(count, handles.data(), &count)) return {};
  handles.resize(std::min(handles.size(), std::size_t(std::max(count, 0))));
  return handles;
}

/// Its first name of these that the driver knows.
EglDevice describe(const Egl& egl, EGLDeviceEXT device) {
  const auto text = [&](EGLint name) {
    return egl.device_string ? egl.device_string(device, name) : nullptr;
  };
  const char* extensions = text(EGL_EXTENSIONS);
  const bool software = extensions && std::strstr(extensions, "EGL_MESA_device_software");
  const char* file = text(EGL_DRM_DEVICE_FILE_EXT);
  const char* renderer = extensions && std::strstr(extensions, "EGL_EXT_device_query_name")
                             ? text(EGL_RENDERER_EXT)
                             : nullptr;
  return {renderer ? renderer : file ? file : software ? "Mesa's llvmpipe" : "unnamed", software};
}

std::vector<EglDevice> describe_all(const Egl& egl, const std::vector<EGLDeviceEXT>& handles) {
  std::vector<EglDevice> devices;
  for (EGLDeviceEXT handle : handles) devices.push_back(describe(egl, handle));
  return devices;
}

/// N of "egl:N".
std::optional<std::size_t> number_in(std::string_view kind) {
  constexpr std::string_view start = "egl:";
  if (!kind.starts_with(start)) return std::nullopt;
  const std::string_view digits = kind.substr(start.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
  if (digits.empty() || error != std::errc() || end != digits.end()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<std::size_t> choose_device(std::span<const EglDevice> devices,
                                         std::string_view kind) {
  if (const auto number = number_in(kind)) {
    if (*number >= devices.size())
      fail(fmt::format("{}: there are {} devices, counted from 0", kind, devices.size()));
    return number;
  }
  if (devices.empty()) return std::nullopt;
  const auto found = std::ranges::find(devices, kind == "egl:software", &EglDevice::software);
  if (found == devices.end())
    fail(kind == "egl" ? "all devices compute in software" : "no device computes in software");
  return std::size_t(found - devices.begin());
}

bool is_gl_kind(std::string_view kind) {
  return kind == "osmesa" || kind == "egl" || kind == "egl:software" || number_in(kind);
}

bool is_software_renderer(std::string_view renderer) {
  constexpr std::string_view known[] = {"llvmpipe", "softpipe", "swrast", "SWR", "Software"};
  return std::ranges::any_of(
      known, [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

std::vector<EglDevice> egl_devices() {
  try {
    const Egl egl;
    return describe_all(egl, handles_of(egl));
  } catch (const WorkError&) {  // EGL is not installed
    return {};
  }
}

std::unique_ptr<GlPlatform> make_egl_platform() {
  return std::make_unique<EglPlatform>(Egl(), EGLDeviceEXT(nullptr));
}

std::unique_ptr<GlPlatform> make_egl_platform(std::string_view kind) {
  Egl egl;
  const std::vector<EGLDeviceEXT> handles = handles_of(egl);
  const auto chosen = choose_device(describe_all(egl, handles), kind);
  if (!chosen) return make_egl_platform();
  return std::make_unique<EglPlatform>(std::move(egl), handles[*chosen]);
}

}  // namespace pellucid::oit
