// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/scene_fingerprint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/pack/sha256.h"
#include "core/files/files_read.h"

namespace pellucid::compare {

std::string scene_fingerprint(const std::set<std::filesystem::path>& files_read,
                              std::string_view option) {
  ContentHashes hashes;
  std::multiset<std::string> contents;  // by their names: folders differ between machines
  for (const std::filesystem::path& file : files_read)
    contents.insert(fmt::format("{} {}", file.filename().string(), hashes.of(file)));
  return sha256(fmt::format("{} {}", fmt::join(contents, " "), option)).substr(0, 16);
}

}  // namespace pellucid::compare
