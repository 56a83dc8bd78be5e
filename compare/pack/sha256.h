// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns the SHA-256 of the bytes (FIPS 180-4) in 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::string_view bytes);

}  // namespace pellucid::compare
