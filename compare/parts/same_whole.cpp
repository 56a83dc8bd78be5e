// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/same_whole.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <string>

#include "core/error.h"

namespace pellucid::compare {
namespace {

/// A Trait is something that parts of one whole have in common, as people read it.
struct Trait {
  const char* name;
  std::string (*value)(const DeepInfo& info);
};

std::string background_text(const DeepInfo& info) {
  const auto& b = info.background;
  return b ? fmt::format("{},{},{}", b->r, b->g, b->b) : "none";
}

/// What a change of the view changes comes before the scene's content, which it may change too.
constexpr Trait traits[] = {
    {"resolution", [](const DeepInfo& i) { return fmt::format("{}x{}", i.width, i.height); }},
    {"camera", [](const DeepInfo& i) { return i.camera; }},
    {"background", background_text},
    {"number of parts", [](const DeepInfo& i) { return std::to_string(i.part.count); }},
    {"program", [](const DeepInfo& i) { return i.program; }},
    {"build", [](const DeepInfo& i) { return i.build; }},
    {"scene", [](const DeepInfo& i) { return i.scene; }},
    {"content of the scene", [](const DeepInfo& i) { return i.fingerprint; }},
    {"set of opaque objects",
     [](const DeepInfo& i) { return fmt::format("{}", fmt::join(i.opaque, " ")); }},
};

}  // namespace

void check_same_picture(const NamedInfo& first, const NamedInfo& other) {
  for (const Trait& trait : traits)
    if (const std::string a = trait.value(first.info), b = trait.value(other.info); a != b)
      throw InputError(
          fmt::format("{}: its {} is {}, of {} it is {}; accepted: parts of one picture",
                      other.file.string(), trait.name, b, first.file.string(), a));
}

void check_same_whole(const std::vector<NamedInfo>& parts) {
  std::map<int, const NamedInfo*> by_number;
  for (const NamedInfo& part : parts) {
    check_same_picture(parts.front(), part);
    const auto [there, is_new] = by_number.try_emplace(part.info.part.part, &part);
    if (!is_new)
      throw InputError(fmt::format("{}: is part {} of {}, as {} is; accepted: each part once",
                                   part.file.string(), part.info.part.part, part.info.part.count,
                                   there->second->file.string()));
  }
  const int count = parts.front().info.part.count;
  for (int number = 1; number <= count; ++number)
    if (!by_number.contains(number))
      throw InputError(fmt::format("{}: part {} of {} is missing; accepted: all parts, each once",
                                   parts.front().file.string(), number, count));
}

}  // namespace pellucid::compare
