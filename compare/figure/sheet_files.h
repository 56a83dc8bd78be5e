// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "compare/figure/figure_request.h"
#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// Writes the sheet by the file's ending, .pdf, .svg or .png, whole or not at all; `title` stands
/// in a PDF's metadata. Throws InputError for another ending, and as OutputFile does.
void write_sheet(const std::filesystem::path& path, const FigureSheet& sheet,
                 const FigureStyle& style, const std::string& title);

/// Throws InputError for an ending that write_sheet() does not write; `further` is one that the
/// caller does, for the message.
void require_sheet_ending(const std::filesystem::path& path, std::string_view further = "");

}  // namespace pellucid::compare
