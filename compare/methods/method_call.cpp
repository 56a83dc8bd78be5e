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

/// A name that goes on as the endings of a cell's further files do (".layers.exr", ".view-2.exr")
/// could be one of them; no ending begins with a digit, as "0.5" goes on.
bool may_be_an_ending(std::string_view slug) {
  for (std::size_t i = 0; i < slug.size(); ++i)
    if (slug[i] == '.' && (i + 1 == slug.size() || !std::isdigit(std::uint8_t(slug[i + 1]))))
      return true;
  return false;
}

}  // namespace

std::string MethodCall::text() const {
  const std::string own = parameters.given();
  return own.empty() ? std::string(row->name) : fmt::format("{}:{}", row->name, own);
}

std::string MethodCall::slug() const { return slug_of(text()); }

std::string slug_of(const std::string& call) {
  constexpr std::size_t longest = 150;  // a file's name has 255 bytes at most, endings among them
  std::string slug = call;
  bool lossy = call.size() > longest || may_be_an_ending(call);
  for (char& c : slug) {
    if (is_file_safe(c)) continue;
    lossy |= std::string_view("-:=,").find(c) == std::string_view::npos;
    c = '-';
  }
  return lossy ? fmt::format("{}-{:08x}", slug.substr(0, 80), short_hash(call)) : slug;
}

}  // namespace pellucid::compare
