// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "compare/report/report_cells.h"

namespace pellucid::compare {

// What the page's viewer asks for by a key when it is looked at: "pixels-3" are the floats of the
// fourth row's picture (packed_words(), predicted by its scene's reference), "layers-3" its numbers
// of layers, "flip-3" and "further-3-0" maps as data URIs. In a report of one file they stand in
// the page, in a folder each in a file of its own.

/// Texts by their keys.
using PageTexts = std::map<std::string, std::string>;

/// Returns the floats of all pictures, rounded to `mantissa_bits` of a float's 23, and their
/// numbers of layers; nothing where all of them are longer than `most_bytes`.
std::optional<PageTexts> pixel_texts(std::span<const ReportCell> cells, int mantissa_bits,
                                     std::size_t most_bytes);

/// Calls visit(key, text) for the exact floats, the layers and the maps of every cell, one cell
/// after another, so that no more than a few cells' are in memory.
void for_each_text(std::span<const ReportCell> cells,
                   const std::function<void(const std::string&, const std::string&)>& visit);

/// Returns a PNG file as a URI that holds all of it.
std::string data_uri(const std::filesystem::path& png);

}  // namespace pellucid::compare
