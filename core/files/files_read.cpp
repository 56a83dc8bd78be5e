// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/files_read.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL  // the algorithm is all in its header
#include <xxhash.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <mutex>
#include <vector>

#include "core/error.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

/// The lists that live, and what guards them and their paths.
struct Listeners {
  std::mutex mutex;
  std::vector<FilesRead*> lists;
  std::vector<const FilesRead*> protect;
  int unnoted = 0;  // of UnnotedReads that live
};

Listeners& listeners() {
  static Listeners all;
  return all;
}

fs::path normal(const fs::path& path) {
  std::error_code code;
  const fs::path absolute = fs::absolute(path, code);
  return without_dots(code ? path : absolute);
}

}  // namespace

fs::path without_dots(const fs::path& path) {
  fs::path normal = path.lexically_normal();
  if (std::ranges::find(path, fs::path("..")) == path.end()) return normal;
  std::error_code code;
  if (!fs::exists(path, code) || fs::equivalent(path, normal, code)) return normal;
  const fs::path folder = fs::canonical(path.parent_path(), code);
  return code ? path : folder / path.filename();
}

FilesRead::FilesRead() {
  const std::lock_guard lock(listeners().mutex);
  listeners().lists.push_back(this);
}

FilesRead::~FilesRead() {
  const std::lock_guard lock(listeners().mutex);
  std::erase(listeners().lists, this);
}

std::set<fs::path> FilesRead::paths() const {
  const std::lock_guard lock(listeners().mutex);
  return paths_;
}

void note_read(const fs::path& path) {
  const std::lock_guard lock(listeners().mutex);
  if (listeners().lists.empty() || listeners().unnoted > 0) return;
  const fs::path noted = normal(path);
  for (FilesRead* list : listeners().lists) list->paths_.insert(noted);
}

UnnotedReads::UnnotedReads() {
  const std::lock_guard lock(listeners().mutex);
  ++listeners().unnoted;
}

UnnotedReads::~UnnotedReads() {
  const std::lock_guard lock(listeners().mutex);
  --listeners().unnoted;
}

ProtectedInputs::ProtectedInputs() {
  const std::lock_guard lock(listeners().mutex);
  listeners().protect.push_back(&read_);
}

ProtectedInputs::~ProtectedInputs() {
  const std::lock_guard lock(listeners().mutex);
  std::erase(listeners().protect, &read_);
}

void ProtectedInputs::refuse(const fs::path& output) {
  std::vector<const FilesRead*> protect;
  {
    const std::lock_guard lock(listeners().mutex);
    protect = listeners().protect;
  }
  for (const FilesRead* list : protect)
    for (const fs::path& input : list->paths()) {
      std::error_code none;  // one of them does not exist: they are not the same
      if (fs::equivalent(input, output, none))
        throw InputError(
            fmt::format("{}: cannot write: it is an input of this command", output.string()));
    }
}

std::string ContentHashes::of(const fs::path& path) {
  const auto [entry, is_new] = known_.try_emplace(normal(path));
  if (!is_new) return entry->second;
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       XXH3_freeState);
  XXH3_64bits_reset(state.get());
  std::vector<char> block(1 << 20);
  while (file && (file.read(block.data(), std::streamsize(block.size())), file.gcount() > 0))
    XXH3_64bits_update(state.get(), block.data(), std::size_t(file.gcount()));
  if (file.eof()) entry->second = fmt::format("{:016x}", XXH3_64bits_digest(state.get()));
  return entry->second;
}

}  // namespace pellucid
