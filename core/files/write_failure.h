// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace pellucid {

/// Throws what a failed system call of number `code` means for who wanted `path` written: a
/// WorkError where the disk is full or broken, otherwise an InputError, since another path would
/// do.
[[noreturn]] void fail_writing(const std::filesystem::path& path, int code);

}  // namespace pellucid
