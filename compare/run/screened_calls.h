// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/run/screening.h"

namespace pellucid::compare {

/// Keeps what screening has found beside a scene's cells, so that a study that is resumed leaves
/// out the same calls; `key` tells whether it is of the same calls, files and program.
///@{
void write_screen(const std::filesystem::path& file, const std::string& key,
                  std::span<const ScreenedCall> screened);
/// Returns nothing where there is none for this key.
std::optional<std::vector<ScreenedCall>> read_screen(const std::filesystem::path& file,
                                                     const std::string& key);
///@}

/// Returns a paragraph for people about how many calls a study left out, by scene.
std::string screen_note(std::span<const std::pair<std::string, std::size_t>> scenes);

/// Returns a line of CSV for each call, without a head: scene, call, size, seconds, rmse, bytes,
/// and the same of the call that beat it.
std::string csv_screen(const std::string& scene, std::span<const ScreenedCall> screened);

}  // namespace pellucid::compare
