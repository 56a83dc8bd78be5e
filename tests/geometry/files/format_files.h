// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {

namespace fs = std::filesystem;

/// Writes files of known content, and holds that whatever is cut off one is refused or leaves a
/// whole. The numbers of files that other programs wrote are compared in
/// tests/app/compare_readers.py.
class FormatFiles : public ::testing::Test {
 protected:
  fs::path file(const std::string& name, std::string_view content) const {
    write_text(folder_ / name, content);
    return folder_ / name;
  }
  template <class Read>
  static std::string refusal(const Read& read) {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "accepted";
    return {};
  }
  /// Of a file cut off anywhere nothing but a refusal that names it leaves the reader.
  template <class Read>
  void expect_cuts_are_refused(const std::string& name, const std::string& whole,
                               const Read& read) const {
    for (std::size_t size = 0; size + 1 < whole.size(); size += 1 + whole.size() / 200)
      EXPECT_THAT(refusal([&] { read(file(name, whole.substr(0, size))); }),
                  ::testing::HasSubstr(name))
          << size;
  }

  testing::TemporaryFolder folder_;
};

template <class T>
std::string bytes_of(const std::vector<T>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const T number : numbers) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    if (big_endian) std::reverse(raw, raw + sizeof raw);
    bytes.append(raw, sizeof raw);
  }
  return bytes;
}

}  // namespace pellucid::geometry
