// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-picture: parses one OpenEXR or PNG file for the process that starts it
// (core/files/child_reader.h).

#include <fstream>

#include "core/files/child_reader.h"
#include "readers/pictures/parse_picture.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  pellucid::run_child_reader(
      argc, argv,
      [](const std::filesystem::path& file, std::span<const std::string>,
         pellucid::BlockWriter& out) {
        const bool is_png = std::ifstream(file, std::ios::binary).get() == 0x89;
        (is_png ? pellucid::readers::parse_png : pellucid::readers::parse_exr)(file, out);
      });
}
