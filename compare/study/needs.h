// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes of data that do not come with the sources, such as a simulation that is fetched: a study
// names the files that they need, and leaves a scene out where one is missing.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/json_node.h"

namespace pellucid::compare {

/// A scene that a study leaves out, by name, and the first file that it needs and lacks.
struct LeftOutScene {
  std::string scene;
  std::filesystem::path missing;
  std::filesystem::path file = {};  // the scene's own

  /// Returns what is told of it, one line.
  std::string text() const;
};

/// Reads {SCENE: FILE or [FILE, …], …}, files relative to `folder`, and returns the scenes that are
/// left out. Throws InputError for a scene that is not among `scenes`, and where all are left out.
std::vector<LeftOutScene> read_needs(const JsonNode& node, const std::filesystem::path& folder,
                                     std::span<const std::string> scenes);

}  // namespace pellucid::compare
