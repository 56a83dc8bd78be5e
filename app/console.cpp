// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/machine/stopwatch.h"
#include "oit/gl/egl_devices.h"

namespace pellucid::app {
namespace {

std::string remaining(double fraction, double elapsed) {
  // Before this the estimate is noise.
  if (fraction < 0.02 || elapsed < 1) return "";
  const double seconds = elapsed * (1 - fraction) / fraction;
  if (seconds < 90) return fmt::format(", {:.0f} s left", seconds);
  return fmt::format(", {:.0f} min left", seconds / 60);
}

/// What was printed last; shared by the copies of one Progress.
struct ConsoleState {
  Stopwatch since_start;
  Stopwatch since_print;
  bool printed = false;
  std::string what;
};

void print_on_terminal(ConsoleState& state, double fraction, std::string_view what) {
  const bool finished = fraction >= 1;
  if (state.printed && !finished && state.since_print.seconds() < 0.1) return;
  std::cerr << fmt::format("\r\x1b[K{:3.0f} %  {}{}", 100 * fraction, what,
                           remaining(fraction, state.since_start.seconds()))
            << (finished ? "\n" : "") << std::flush;
  state.printed = true;
  state.since_print.restart();
}

void print_as_line(ConsoleState& state, double fraction, std::string_view what) {
  if (state.printed && state.what == what && state.since_print.seconds() < 10) return;
  std::cerr << fmt::format("{:3.0f} %  {}{}\n", 100 * fraction, what,
                           remaining(fraction, state.since_start.seconds()));
  state.printed = true;
  state.what = what;
  state.since_print.restart();
}

/// An empty text would count as an option that was not given: a script's variable may be unset.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (std::ranges::any_of(option->results(), &std::string::empty))
      throw InputError(
          fmt::format("{0}: an empty text; accepted: a value, or no {0}", option->get_name()));
}

}  // namespace

Progress console_progress(const GlobalOptions& globals) {
  if (globals.quiet) return {};
  const auto state = std::make_shared<ConsoleState>();
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return [state, terminal](double fraction, std::string_view what) {
    terminal ? print_on_terminal(*state, fraction, what) : print_as_line(*state, fraction, what);
  };
}

void add_global_options(CLI::App& command, GlobalOptions& globals) {
  command.add_flag("--json", globals.json, "Print JSON");
  command.add_flag("--quiet", globals.quiet, "Print no progress");
  command.add_option("--threads", globals.threads, "Threads; 0: as many as the machine has")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.parse_complete_callback([&command] {
    refuse_empty_values(command);
    require_distinct_outputs(command);
  });
}

CLI::Validator ending_among(const std::vector<std::string>& endings) {
  return CLI::Validator(
      [endings](const std::string& path) {
        const std::string ending = std::filesystem::path(path).extension().string();
        if (std::ranges::find(endings, small_ending(path)) != endings.end()) return std::string();
        return fmt::format("{}: ending '{}'; accepted: {}", path, ending, fmt::join(endings, ", "));
      },
      fmt::format("{}", fmt::join(endings, "|")));
}

CLI::Validator finite_number() {
  const auto complaint = [](std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return {};
    return fmt::format("'{}'; accepted: a finite number", text);
  };
  return {complaint, "FINITE"};
}

CLI::Option* add_opacities_option(CLI::App& command, std::string& opacities) {
  return command.add_option(
      "--opacities", opacities,
      "Composite the opacities of least energy that this method finds, such as "
      "'decoupled-lists' or 'fourier-opacity:bands=5'; the scene's weights hold");
}

void add_gl_option(CLI::App& command, GlobalOptions& globals) {
  const auto complaint = [](std::string& text) -> std::string {
    if (oit::is_gl_kind(text)) return {};
    return fmt::format("'{}'; accepted: {}", text, oit::accepted_gl);
  };
  command
      .add_option("--gl", globals.gl,
                  "Where OpenGL runs: osmesa (software), egl (the first graphics card), egl:N (a "
                  "device by its number), egl:software; see 'list gl'")
      ->check(CLI::Validator(complaint, "GL"))
      ->capture_default_str();
}

}  // namespace pellucid::app
