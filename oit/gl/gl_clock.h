// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "oit/gl/gl_objects.h"

namespace pellucid::oit {

/// A GlClock takes the time between two places in the stream of commands by the driver's own clock
/// (glQueryCounter, core since OpenGL 3.3), where it has one: what the program does between its
/// commands, and what the driver does before it draws, is not in it.
class GlClock {
 public:
  explicit GlClock(const Gl& gl);

  void start() const;
  void stop() const;
  /// Returns the seconds from start() to stop(), waiting until OpenGL has come there; nothing where
  /// the driver has no clock.
  std::optional<double> seconds() const;

 private:
  const Gl& gl_;
  GLint bits_ = 0;  // of the clock, which begins again at 0 after 2^bits nanoseconds
  GlName<&Gl::DeleteQueries> begin_, end_;
};

}  // namespace pellucid::oit
