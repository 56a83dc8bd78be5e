// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/gate.h"

#include <fmt/format.h>

#include <random>

namespace pellucid::view {
namespace {

constexpr std::size_t longest_path = 1000;
constexpr std::string_view scheme = "http://";

}  // namespace

std::string random_token() {
  std::random_device random;  // the kernel's
  std::string token;
  for (int word = 0; word < 4; ++word) token += fmt::format("{:08x}", random());
  return token;
}

/// In a time that does not depend on where it differs.
bool Gate::knows_token(std::string_view path) const {
  const std::size_t length = token_.size();
  if (path.size() < length + 2 || path[0] != '/' || path[length + 1] != '/') return false;
  unsigned char different = 0;
  for (std::size_t i = 0; i < length; ++i)
    different |= static_cast<unsigned char>(path[i + 1] ^ token_[i]);
  return different == 0;
}

/// The port may be left out where it is HTTP's own, and browsers and curl leave it out.
bool Gate::is_here(std::string_view host) const {
  constexpr int http_port = 80;
  if (port_ == http_port && (host == "127.0.0.1" || host == "localhost")) return true;
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

std::optional<Answer> Gate::refuse(const Question& question) const {
  if (!is_here(question.host))
    return failure(403, fmt::format("Host: accepted: 127.0.0.1:{}", port_));
  const std::string_view origin = question.origin;
  if (!origin.empty() && !(origin.starts_with(scheme) && is_here(origin.substr(scheme.size()))))
    return failure(403, "Origin: accepted: this page's own");
  if (question.path.size() > longest_path || !knows_token(question.path))
    return failure(403, "accepted: the address that the program has printed");
  return std::nullopt;
}

std::string_view Gate::inner_path(const Question& question) const {
  return std::string_view(question.path).substr(token_.size() + 2);
}

std::string Gate::address() const { return fmt::format("http://127.0.0.1:{}/{}/", port_, token_); }

}  // namespace pellucid::view
