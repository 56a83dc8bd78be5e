// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace pellucid::readers {

/// Walks the head of an OpenVDB file, its grid descriptors and each grid's metadata, and throws
/// InputError where a length or a count claims more than the file holds. OpenVDB itself allocates
/// and fills whatever such a claim says. Nothing of the trees is looked at.
void precheck_vdb(const std::filesystem::path& path);

}  // namespace pellucid::readers
