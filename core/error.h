// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pellucid {

/// The longest message, in characters: what is beyond says nothing to a reader.
inline constexpr std::size_t longest_message = 400;

/// Returns the text as one line of valid UTF-8, whatever a file or a library has put into it:
/// control characters become C's escapes, bytes that are no UTF-8 the replacement character;
/// what is longer than `most` characters ends with an ellipsis, between characters.
std::string one_line(std::string_view text, std::size_t most = longest_message);

/// An InputError says that the caller's input or call is wrong, in one line: where, what was got,
/// what is accepted. The program exits with code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view what) : std::runtime_error(one_line(what)) {}
};

/// A WorkError says that the work itself failed, in one line: disk full, out of memory, a driver
/// that lacks something. The program exits with code 1.
class WorkError : public std::runtime_error {
 public:
  explicit WorkError(std::string_view what) : std::runtime_error(one_line(what)) {}
};

}  // namespace pellucid
