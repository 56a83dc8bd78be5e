// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucid {

/// A ProgramRun says how a program ended.
struct ProgramRun {
  int exit_code = -1;      // -1: it was ended by a signal
  int signal = 0;          // that ended it
  bool timed_out = false;  // by this process, since it took too long
  double seconds = 0;      // wall clock, from its start to its end
  double limit = 0;        // the longest that it was given, seconds

  bool succeeded() const { return exit_code == 0 && !timed_out; }
  /// Returns how it failed, such as "ended with code 3".
  std::string failure() const;
};

/// A ProgramPlace says where a program runs, and where what it prints goes.
struct ProgramPlace {
  std::filesystem::path folder;  // its current folder
  std::filesystem::path out, err;
  bool is_temporary = false;  // the folder goes, with all in it, where this process ends first
};

/// Returns the file that the first word of a command names: relative to `base` where the word has a
/// '/', else the first on the PATH. Empty when there is none that may be run.
std::filesystem::path find_program(std::string_view word, const std::filesystem::path& base);

/// Runs the program with these words (the first is its own name), without a shell and without
/// input, waits for its end, and ends it and all that it has started after `timeout` seconds; they
/// end with this process too. Throws WorkError when it cannot be started, Cancelled when the
/// tbb::task_group_context of the call is cancelled meanwhile.
ProgramRun run_program(const std::filesystem::path& program, const std::vector<std::string>& words,
                       const ProgramPlace& place, double timeout);

/// Splits a command at spaces; quotes, single or double, keep what is between them together. No
/// shell sees it. Throws InputError for a quote without its end and for no words at all.
std::vector<std::string> split_command(std::string_view text);

}  // namespace pellucid
