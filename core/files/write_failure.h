// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace pellucid {

/// Throws what a failed system call of number `code` means for who wanted `path` written: a
/// WorkError where the disk is full or broken or a limit of sizes is reached, otherwise an
/// InputError, since another path would do.
[[noreturn]] void fail_writing(const std::filesystem::path& path, int code);

/// Throws a WorkError for a stream that has just taken no more of what was to be `path`: with
/// the reason that the system gave (errno), which streams do not keep, where it is one of those.
[[noreturn]] void fail_stream(const std::filesystem::path& path);

}  // namespace pellucid
