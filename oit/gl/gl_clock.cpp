// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/gl_clock.h"

namespace pellucid::oit {
namespace {

GlName<&Gl::DeleteQueries> time_query(const Gl& gl) {
  GLuint id = 0;
  gl.CreateQueries(GL_TIMESTAMP, 1, &id);
  return {gl, id};
}

}  // namespace

GlClock::GlClock(const Gl& gl) : gl_(gl) {
  gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits_);
  if (bits_ == 0) return;
  begin_ = time_query(gl);
  end_ = time_query(gl);
}

void GlClock::start() const {
  if (bits_ > 0) gl_.QueryCounter(begin_.id(), GL_TIMESTAMP);
}

void GlClock::stop() const {
  if (bits_ > 0) gl_.QueryCounter(end_.id(), GL_TIMESTAMP);
}

std::optional<double> GlClock::seconds() const {
  if (bits_ == 0) return std::nullopt;
  std::uint64_t begin = 0, end = 0;
  gl_.GetQueryObjectui64v(begin_.id(), GL_QUERY_RESULT, &begin);
  gl_.GetQueryObjectui64v(end_.id(), GL_QUERY_RESULT, &end);
  const std::uint64_t wrap = bits_ < 64 ? (std::uint64_t(1) << bits_) - 1 : ~std::uint64_t(0);
  return 1e-9 * double((end - begin) & wrap);
}

}  // namespace pellucid::oit
