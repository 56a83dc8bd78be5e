// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "app/commands.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

/// The options whose values are files that a command writes.
constexpr std::array<std::string_view, 9> outputs{
    "output", "stats", "layers", "probe-out", "sums", "deep", "diff", "flip-map", "error-picture"};

bool is_output(const CLI::Option& option) {
  return std::ranges::any_of(
      outputs, [&](std::string_view name) { return option.check_lname(std::string(name)); });
}

/// A device or a pipe takes what comes, one thing after another.
bool is_kept(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::is_character_file(status) && !fs::is_fifo(status);
}

/// The same for all ways to write a path, links among them; the file need not be there.
fs::path place_of(const fs::path& path) {
  std::error_code failed;
  const fs::path place = fs::weakly_canonical(fs::absolute(behind_links(path)), failed);
  return failed ? path.lexically_normal() : place;
}

}  // namespace

void require_distinct_outputs(const CLI::App& command) {
  std::map<fs::path, std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->empty() || !is_output(*option)) continue;
    const std::string path = option->as<std::string>();
    if (path.empty() || !is_kept(path)) continue;
    const auto [other, is_new] = options.emplace(place_of(path), option->get_name());
    if (!is_new)
      throw InputError(fmt::format("{} and {}: both are {}; accepted: a file for each",
                                   other->second, option->get_name(), path));
  }
}

}  // namespace pellucid::app
