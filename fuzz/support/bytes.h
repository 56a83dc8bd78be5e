// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pellucid::fuzz {

/// Bytes are one input of a target, as it came from the fuzzer or from a file of the corpus.
using Bytes = std::span<const std::uint8_t>;

/// Returns bytes as text, or text as bytes.
///@{
inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
///@}

}  // namespace pellucid::fuzz
