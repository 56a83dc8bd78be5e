// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace pellucid::compare {

/// Returns a path as a page asks for it: bytes that mean something else in a URL, as '?', '#' and
/// '%' do, are written by their numbers (RFC 3986, section 2.1).
std::string url_of(const std::filesystem::path& path);

}  // namespace pellucid::compare
