// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/bindings.h"
#include "oit/gl/gl_objects.h"

namespace pellucid::oit {

/// A FragmentPool holds places for the nodes of per-pixel lists (fragment_list.glsl), in texture
/// buffers: a storage block ends at 128 MiB.
struct FragmentPool {
  std::uint64_t nodes = 0;  // without node 0, which ends a list
  BufferTexture links, colors;

  std::uint64_t bytes() const { return links.bytes() + colors.bytes(); }
  Resources resources() const {
    return {links.as_image(bindings::nodes_image), colors.as_image(bindings::node_colors_image)};
  }
};

/// Makes a pool for so many nodes, 32 bytes each. Throws WorkError "METHOD: …" when the driver's
/// largest texture buffer holds fewer.
FragmentPool make_fragment_pool(const Gl& gl, std::string_view method, std::uint64_t nodes);

/// Returns how many nodes the driver's largest texture buffer holds.
std::uint64_t most_nodes(const Gl& gl);

/// Throws WorkError "METHOD: the picture has COUNT WHAT, …" when that is more than a texture buffer
/// holds, texel 0 aside.
void check_texel_count(const Gl& gl, std::string_view method, std::uint64_t count,
                       std::string_view what);

}  // namespace pellucid::oit
