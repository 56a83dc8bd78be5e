// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "compare/report/report_cells.h"

namespace pellucid::compare {

/// So many small pictures of views a page of one file holds, of all scenes and methods: some 10 MB.
constexpr std::size_t most_view_pictures = 1000;

/// Returns how many pictures view_pictures() would make of all cells.
std::size_t count_view_pictures(std::span<const ReportCell> cells);

/// Returns a source of each view's picture of a done cell of a study of several views: of the
/// reference its picture, of others their error map. That of a page of one file stands in it, at
/// most 96 pixels wide; that of a folder's page, `folder`, beside it. Empty for one view; null for
/// a view whose picture is missing.
nlohmann::json view_pictures(const ReportCell& cell, const std::filesystem::path& folder,
                             bool in_folder);

}  // namespace pellucid::compare
