// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/gl_context.h"

#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"
#include "oit/gl/egl_devices.h"

namespace pellucid::oit {
namespace {

std::unique_ptr<GlPlatform> make_platform(std::string_view kind) {
  if (kind == "osmesa") return make_osmesa_platform();
  if (is_gl_kind(kind)) return make_egl_platform(kind);
  throw InputError(fmt::format("gl: '{}'; accepted: {}", kind, accepted_gl));
}

Gl load(GlPlatform& platform) {
  Gl gl;
#define PELLUCID_GL_LOAD(name, type_name)                                               \
  gl.name = reinterpret_cast<PFNGL##type_name##PROC>(platform.entry_point("gl" #name)); \
  if (!gl.name) throw WorkError("the OpenGL driver has no entry point gl" #name);
  PELLUCID_GL_ENTRY_POINTS(PELLUCID_GL_LOAD)
#undef PELLUCID_GL_LOAD
  return gl;
}

void APIENTRY remember_error(GLenum, GLenum type, GLuint, GLenum, GLsizei length,
                             const GLchar* text, const void* message) {
  if (type == GL_DEBUG_TYPE_ERROR)
    static_cast<std::string*>(const_cast<void*>(message))->assign(text, std::size_t(length));
}

std::string driver_name(const Gl& gl) {
  const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(gl.GetString(name)); };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

/// Mesa's threads, which all contexts of a process share, are not there in one that it forks: who
/// waits for them there waits for ever.
void refuse_fork() {
  static const pid_t first = ::getpid();
  if (::getpid() != first)
    throw WorkError(
        "OpenGL was used before this process was forked, and cannot be used in it; accepted: a "
        "process that is started anew, as by Python's multiprocessing with 'spawn'");
}

}  // namespace

GlContext::GlContext(std::string_view kind)
    : platform_(make_platform(kind)), message_(std::make_unique<std::string>()) {
  refuse_fork();
  platform_->make_current();
  gl_ = load(*platform_);
  driver_ = driver_name(gl_);
  // Drivers without a word fall back to software, whose times would be taken for a graphics card's.
  if (kind == "egl" && is_software_renderer(driver_))
    throw WorkError(
        fmt::format("EGL: the driver is {}; accepted with --gl egl: a graphics card's; "
                    "with --gl egl:software or osmesa: this",
                    driver_));
  gl_.Enable(GL_DEBUG_OUTPUT);
  gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl_.DebugMessageCallback(remember_error, message_.get());
  gl_.Disable(GL_MULTISAMPLE);
  gl_.Disable(GL_DITHER);
  check("making the context");
}

GlContext::~GlContext() = default;

void GlContext::check(std::string_view what) const {
  const GLenum error = gl_.GetError();
  if (error == GL_NO_ERROR) return;
  throw WorkError(fmt::format("OpenGL error {:#06x} while {}: {} ({})", error, what,
                              message_->empty() ? "no message" : *message_, driver_));
}

}  // namespace pellucid::oit
