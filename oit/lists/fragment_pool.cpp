// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/lists/fragment_pool.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::oit {

FragmentPool make_fragment_pool(const Gl& gl, std::string_view method, std::uint64_t nodes) {
  check_texel_count(gl, method, nodes, "fragments");
  const std::uint64_t n = nodes + 1;
  return {nodes, {gl, GL_RGBA32UI, 16 * n}, {gl, GL_RGBA32F, 16 * n}};
}

// Node 0 ends a list.
std::uint64_t most_nodes(const Gl& gl) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return std::uint64_t(most) - 1;
}

void check_texel_count(const Gl& gl, std::string_view method, std::uint64_t count,
                       std::string_view what) {
  if (count > most_nodes(gl))
    throw WorkError(
        fmt::format("{}: the picture has {} {}, but the driver's largest texture buffer holds {}; "
                    "draw a smaller picture",
                    method, count, what, most_nodes(gl)));
}

}  // namespace pellucid::oit
