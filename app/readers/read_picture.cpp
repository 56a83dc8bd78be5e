// SPDX-License-Identifier: GPL-3.0-or-later
// pellucid-read-picture: parses one OpenEXR or PNG file for the process that starts it
// (core/files/child_reader.h). With "deep" it is a deep picture's head that is asked for, with
// "deep" and two numbers its rows from the first up to and without the second, with "text" and a
// name the text of that attribute.

#include <cstdlib>
#include <fstream>

#include "core/files/child_reader.h"
#include "readers/pictures/parse_deep.h"
#include "readers/pictures/parse_picture.h"

// What a broken library throws besides ends it. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  namespace readers = pellucid::readers;
  pellucid::run_child_reader(argc, argv,
                             [](const std::filesystem::path& file,
                                std::span<const std::string> what, pellucid::BlockWriter& out) {
                               if (what.size() == 3)
                                 return readers::parse_deep_rows(file, std::atoi(what[1].c_str()),
                                                                 std::atoi(what[2].c_str()), out);
                               const bool is_png =
                                   std::ifstream(file, std::ios::binary).get() == 0x89;
                               if (what.size() == 2) {
                                 if (!is_png) readers::parse_exr_text(file, what[1].c_str(), out);
                                 return;
                               }
                               if (what.size() == 1) return readers::parse_deep_head(file, out);
                               (is_png ? readers::parse_png : readers::parse_exr)(file, out);
                             });
}
