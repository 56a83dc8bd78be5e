// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace pellucid::readers {

/// Returns the place among a file's times of the one that is asked for: "first", "last", or a
/// number, which has to be one of them up to a millionth. Throws InputError, naming `path`, with
/// the times there are.
std::size_t chosen_time(std::span<const double> times, const std::string& wanted,
                        const std::filesystem::path& path);

}  // namespace pellucid::readers
