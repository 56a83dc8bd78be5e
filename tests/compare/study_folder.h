// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::testing {}

namespace pellucid::compare::testing {

using namespace pellucid::testing;

inline void write_scene(const std::filesystem::path& path, int width, int height) {
  write_text(
      path.parent_path() / "triangle.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_text(path, R"({"format": "pellucid-scene", "version": 1, "resolution": [)" +
                       std::to_string(width) + ", " + std::to_string(height) +
                       R"(], "objects": [{"mesh": "triangle.ply"}]})");
}

/// Two scenes, and a place for a study of them.
class StudyFolder : public TemporaryFolder {
 public:
  StudyFolder() {
    write_scene(*this / "one.json", 24, 16);
    write_scene(*this / "two.json", 13, 40);
  }

  /// A study of both scenes with these methods, given as JSON.
  std::filesystem::path study(const std::string& methods,
                              const std::string& more = R"("repeats": 2)") const {
    const auto path = *this / "study.json";
    write_text(path, R"({"format": "pellucid-study", "version": 1, "title": "T & <t>",
      "scenes": ["one.json", "two.json"], "reference": "truth", "methods": )" +
                         methods + (more.empty() ? "" : ", " + more) + "}");
    return path;
  }
};

}  // namespace pellucid::compare::testing
