// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "compare/renderers/renderer_list.h"

namespace pellucid::compare {

/// Writes FOLDER/report.html, one page without scripts that shows what each renderer makes of each
/// case beside the right picture, and the same in results.json and table.md.
void write_renderers_report(const std::filesystem::path& folder, const std::string& title,
                            std::span<const RendererResult> results);

}  // namespace pellucid::compare
