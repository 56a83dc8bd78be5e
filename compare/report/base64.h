// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns the bytes in base64 (RFC 4648, section 4), padded, as data URIs have it.
std::string base64(std::string_view bytes);

}  // namespace pellucid::compare
