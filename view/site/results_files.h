// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "view/site/site.h"

namespace pellucid::view {

/// Returns what may be seen of a study's folder: its report, and the scenes of its study that are
/// where they were. Throws InputError when the folder has no report.html, and as read_past_run()
/// does.
SiteContent results_content(const std::filesystem::path& folder);

/// Returns a file of a study's folder by its path from there; 404 for what is not in it, by
/// whichever way out: "..", an absolute path, a link. The report gets a line with links to the
/// scenes.
Answer results_file(const std::filesystem::path& folder, std::string_view path,
                    std::span<const SceneFile> scenes);

}  // namespace pellucid::view
