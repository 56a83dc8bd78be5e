// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "compare/renderers/renderer_list.h"

namespace pellucid::compare {

/// A RenderersHead is what a report says before its numbers.
struct RenderersHead {
  std::string title;
  double tolerance = conformance_tolerance;  // that the pictures were judged by
};

/// Writes FOLDER/report.html, one page without scripts that shows what each renderer makes of each
/// case beside the right picture, and the same in results.json and table.md.
void write_renderers_report(const std::filesystem::path& folder, const RenderersHead& head,
                            std::span<const RendererResult> results);

/// Returns what results.json holds.
nlohmann::ordered_json renderers_json(const RenderersHead& head,
                                      std::span<const RendererResult> results);

}  // namespace pellucid::compare
