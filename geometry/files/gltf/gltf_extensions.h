// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pellucid::geometry {

/// Returns why a document that requires the extension is refused; nothing when it is read, or when
/// triangles, lines, points and their colours come out as they are without it.
std::string gltf_extension_refusal(std::string_view name);

/// Returns what is said of a document that uses the extension and does not require it; nothing when
/// what is drawn does not hang on it.
std::string gltf_extension_remark(std::string_view name);

}  // namespace pellucid::geometry
