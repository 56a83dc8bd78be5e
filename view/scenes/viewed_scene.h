// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/progress.h"
#include "scene/scene.h"
#include "view/scenes/view_state.h"

namespace pellucid::view {

/// A ViewedScene is a scene file, loaded once and looked at in many ways. It is of one thread.
class ViewedScene {
 public:
  /// Loads the scene. Throws as load_scene() does.
  explicit ViewedScene(std::filesystem::path file, const Progress& progress = {});

  /// Returns what a page has to know: "name", "size", "camera" and "samples" as the file has them,
  /// "objects" with their names and control_rows(), "views", the table of directions.
  nlohmann::ordered_json description() const;

  /// Returns the scene as a page looks at it; it stays until the next call. Geometry is neither
  /// read nor integrated again, but where an isosurface is extracted. Throws InputError for
  /// settings that an object does not have.
  const scene::Scene& look(const ViewState& state);

  const std::filesystem::path& file() const { return file_; }

 private:
  scene::Scene restyled(const std::vector<RawOptions>& objects) const;
  scene::Scene& styled(const std::vector<RawOptions>& objects);

  std::filesystem::path file_;
  nlohmann::json text_;
  scene::Scene loaded_;                   // as the file has it, but for the view
  std::optional<scene::Scene> restyled_;  // with settings_; none: there are none
  std::vector<RawOptions> settings_;
};

}  // namespace pellucid::view
