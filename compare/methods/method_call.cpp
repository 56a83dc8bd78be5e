// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/method_call.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>

namespace pellucid::compare {
namespace {

/// FNV-1a, 32 bits: tells apart names that look alike once their odd characters are gone.
std::uint32_t short_hash(std::string_view text) {
  std::uint32_t hash = 2166136261u;
  for (const char c : text) hash = (hash ^ std::uint8_t(c)) * 16777619u;
  return hash;
}

bool is_file_safe(char c) {
  return std::isalnum(std::uint8_t(c)) || c == '.' || c == '_' || c == '+';
}

}  // namespace

std::string MethodCall::text() const {
  const std::string own = parameters.given();
  return own.empty() ? std::string(row->name) : fmt::format("{}:{}", row->name, own);
}

std::string MethodCall::slug() const { return slug_of(text()); }

std::string slug_of(const std::string& call) {
  std::string slug = call;
  bool lossy = false;
  for (char& c : slug) {
    if (is_file_safe(c)) continue;
    lossy |= std::string_view("-:=,").find(c) == std::string_view::npos;
    c = '-';
  }
  return lossy ? fmt::format("{}-{:08x}", slug.substr(0, 80), short_hash(call)) : slug;
}

}  // namespace pellucid::compare
