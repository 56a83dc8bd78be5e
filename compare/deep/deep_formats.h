// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The writers that make_deep_writer() picks from.

#include "compare/deep/deep_writer.h"

namespace pellucid::compare {

/// Returns the writer of an .exr or an .npz, as make_deep_writer() does.
///@{
std::unique_ptr<DeepWriter> make_exr_writer(const std::filesystem::path& path,
                                            const DeepInfo& info);
std::unique_ptr<DeepWriter> make_npz_writer(const std::filesystem::path& path,
                                            const DeepInfo& info);
///@}

}  // namespace pellucid::compare
