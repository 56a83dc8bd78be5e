// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "oit/gl/gl.h"
#include "oit/gl/gl_platform.h"

namespace pellucid::oit {

/// A GlContext is an OpenGL 4.5 core context without a window. It belongs to whoever made it; it is
/// current on the thread that last called make_current().
class GlContext {
 public:
  /// Makes a context of the kind "osmesa" or "egl", which is then current. Throws InputError for
  /// another kind, WorkError when there is none or when the driver lacks an entry point.
  explicit GlContext(std::string_view kind);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  void make_current() const { platform_->make_current(); }
  const Gl& gl() const { return gl_; }
  /// Returns renderer and version as the driver reports them.
  const std::string& driver() const { return driver_; }
  /// Throws WorkError with the driver's own words when OpenGL has reported an error since the last
  /// call; `what` says there what was being done.
  void check(std::string_view what) const;

 private:
  std::unique_ptr<GlPlatform> platform_;
  Gl gl_;
  std::string driver_;
  std::unique_ptr<std::string> message_;  // the driver's last; its address is given to the driver
};

}  // namespace pellucid::oit
