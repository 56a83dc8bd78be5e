// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/scene_fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "compare/pack/sha256.h"
#include "core/files/files_read.h"

namespace pellucid::compare {

std::string scene_fingerprint(const std::set<std::filesystem::path>& files_read,
                              std::string_view option) {
  ContentHashes hashes;
  std::vector<std::pair<std::string, std::string>> contents;  // of each file, by its name
  for (const std::filesystem::path& file : files_read)
    contents.emplace_back(file.filename().string(), hashes.of(file));
  // By names, since folders differ between machines; those of one name stay in the order of their
  // paths: x/m.ply and y/m.ply that have changed places are another scene.
  std::ranges::stable_sort(contents, {}, &std::pair<std::string, std::string>::first);
  std::string text;
  for (const auto& [name, hash] : contents) text += fmt::format("{} {} ", name, hash);
  return sha256(text + std::string(option)).substr(0, 16);
}

}  // namespace pellucid::compare
