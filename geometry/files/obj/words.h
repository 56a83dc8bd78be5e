// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

namespace pellucid::geometry {

/// A Words takes the words of one line of an .obj or .mtl file, which are split at blanks; what is
/// behind a # is a comment.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line.substr(0, line.find('#'))) {}

  /// Takes the next word; an empty one when there are no more.
  std::string_view next() {
    skip_blanks();
    const std::size_t end = std::min(rest_.find_first_of(blanks), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  /// Takes all that is left, without the blanks around it: a name may hold some.
  std::string_view rest() {
    skip_blanks();
    const std::string_view rest = rest_.substr(0, rest_.find_last_not_of(blanks) + 1);
    rest_ = {};
    return rest;
  }

 private:
  static constexpr std::string_view blanks = " \t\r";

  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  }

  std::string_view rest_;
};

}  // namespace pellucid::geometry
