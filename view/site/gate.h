// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "view/site/exchange.h"

namespace pellucid::view {

/// Returns 32 hexadecimal digits that nobody can guess.
std::string random_token();

/// A Gate lets in who was given the address. Whatever a browser on this machine has open may ask
/// 127.0.0.1: pages of others are known by Origin, names that were made to point here by Host,
/// other users of the machine by the token that they lack.
class Gate {
 public:
  Gate(std::string token, int port) : token_(std::move(token)), port_(port) {}

  /// Returns what is wrong with the question, 403, or nothing.
  std::optional<Answer> refuse(const Question& question) const;

  /// Returns the path below the token, without a first "/"; the question was not refused.
  std::string_view inner_path(const Question& question) const;

  /// Returns the address that lets in.
  std::string address() const;

 private:
  bool knows_token(std::string_view path) const;
  bool is_here(std::string_view host) const;

  std::string token_;
  int port_;
};

}  // namespace pellucid::view
