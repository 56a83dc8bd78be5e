// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/support/file_in_memory.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace pellucid::fuzz {
namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
  const bool shared = !::getenv("TMPDIR") && fs::is_directory("/dev/shm");
  const fs::path place = shared ? fs::path("/dev/shm") : fs::temp_directory_path();
  std::string name = (place / "pellucid-fuzz-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
  return name;
}

void write(const fs::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  if (!file.write(content.data(), std::streamsize(content.size())).flush())
    throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

FileInMemory::FileInMemory(std::string_view name,
                           std::initializer_list<std::pair<std::string_view, std::string>> beside)
    : folder_(new_folder()), path_(folder_ / name) {
  for (const auto& [other, content] : beside) write(folder_ / other, content);
}

FileInMemory::~FileInMemory() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

const fs::path& FileInMemory::with(Bytes bytes) const {
  write(path_, text_of(bytes));
  return path_;
}

}  // namespace pellucid::fuzz
