// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that a library parses are read in a process of their own: VTK and OpenVDB trust what a file
// says, and a wrong count in one writes past their memory, loops or asks for all there is. The
// process has limits of memory and time by the file's size; what it read it leaves as blocks, of
// which this process checks every claim. If it dies, that is one line about the file.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/blocks.h"

namespace pellucid {

/// ReadLimits are what a process may use to read one file.
struct ReadLimits {
  std::uint64_t bytes = 0;    // of address space, and of what it leaves
  unsigned cpu_seconds = 0;   // of all its threads together
  unsigned wall_seconds = 0;  // against waiting for ever
};

/// Returns the limits for a file of `size` bytes: 1 GiB and 64 times its size; 5 s and a second per
/// MiB; ten times as long by the clock. Only files of more than a GiB that were compressed to less
/// than a 64th of it, a large field of one value, need more.
ReadLimits read_limits(std::uint64_t size);

/// Runs the helper_program() of this name on the file with further arguments, and returns the
/// blocks that it leaves. Its limits are read_limits() of the file's bytes and those `beside` it,
/// of other files that the program reads, and no less than `at_least` bytes. Notes
/// that file and program were read. Throws InputError that names the file when it is no regular
/// file, when the program complains of it, dies over it or exceeds the limits; WorkError when the
/// program cannot be started.
Blocks read_in_child(std::string_view program, const std::filesystem::path& file,
                     const std::vector<std::string>& arguments = {}, std::uint64_t at_least = 0,
                     std::uint64_t beside = 0);

/// Is all that such a program does: sets the limits that its parent gave, calls
/// read(file, further arguments, out), leaves what it throws as the complaint, and ends the
/// process. No library is asked to clean up, which one that a file has damaged may not survive.
[[noreturn]] void run_child_reader(
    int argc, char** argv,
    const std::function<void(const std::filesystem::path&, std::span<const std::string>,
                             BlockWriter&)>& read);

}  // namespace pellucid
