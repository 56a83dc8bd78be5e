// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/progress.h"
#include "scene/files/view_request.h"

namespace pellucid::app {

/// Options that every command takes.
struct GlobalOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;  // 0: as many as the machine has
  std::string gl = "osmesa";
  std::string command_line;  // as it was given, for provenance
};

/// Each adds one subcommand, in app/NAME.cpp, whose callback runs it. Errors leave as InputError or
/// WorkError; main() prints them and picks the exit code.
void add_study_command(CLI::App& app, GlobalOptions& globals);
void add_render_command(CLI::App& app, GlobalOptions& globals);
void add_merge_command(CLI::App& app, GlobalOptions& globals);
void add_frames_command(CLI::App& app, GlobalOptions& globals);
void add_compare_command(CLI::App& app, GlobalOptions& globals);
void add_pack_command(CLI::App& app, GlobalOptions& globals);
void add_figure_command(CLI::App& app, GlobalOptions& globals);
void add_trace_command(CLI::App& app, GlobalOptions& globals);
void add_tune_command(CLI::App& app, GlobalOptions& globals);
void add_export_command(CLI::App& app, GlobalOptions& globals);
void add_conform_command(CLI::App& app, GlobalOptions& globals);
void add_data_command(CLI::App& app, GlobalOptions& globals);
void add_info_command(CLI::App& app, GlobalOptions& globals);
void add_crossings_command(CLI::App& app, GlobalOptions& globals);
void add_view_command(CLI::App& app, GlobalOptions& globals);
void add_list_command(CLI::App& app, GlobalOptions& globals);

/// Adds --json, --quiet and --threads to a subcommand, which then refuses to write two of its
/// outputs into one file.
void add_global_options(CLI::App& command, GlobalOptions& globals);

/// Throws InputError where two options of the command, as it was called, name one file to write.
void require_distinct_outputs(const CLI::App& command);

/// Adds --gl to a subcommand that may render by OpenGL.
void add_gl_option(CLI::App& command, GlobalOptions& globals);

/// Adds --opacities to a subcommand that may optimize opacities before any method composites them;
/// returns it.
CLI::Option* add_opacities_option(CLI::App& command, std::string& opacities);

/// The longest side of a picture that is held in memory, as a scene's file accepts it, and of one
/// that is drawn by tiles; pixels.
inline constexpr int largest_side = 1 << 14, largest_tiled_side = 1 << 15;

/// Adds --camera, --view, --resolution and --samples to a subcommand that renders a scene; they go
/// before what the scene's file says.
void add_view_options(CLI::App& command, scene::ViewRequest& view, int most = largest_side);

/// Accepts paths with one of these endings: a wrong name of an output is met before the work that
/// would be in vain.
CLI::Validator ending_among(const std::vector<std::string>& endings);

/// Accepts numbers but NaN and infinity, which would switch a bound off.
CLI::Validator finite_number();

/// Prints how far the work is to stderr: one line that is rewritten, with an estimate of the time
/// left, on a terminal; plain lines elsewhere; nothing when quiet.
Progress console_progress(const GlobalOptions& globals);

}  // namespace pellucid::app
