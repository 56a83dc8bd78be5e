// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/deep/deep_writer.h"

#include <fmt/format.h>

#include "compare/deep/deep_formats.h"
#include "core/error.h"
#include "core/files/ending.h"

namespace pellucid::compare {

std::unique_ptr<DeepWriter> make_deep_writer(const std::filesystem::path& path,
                                             const DeepInfo& info) {
  const std::string ending = small_ending(path);
  if (ending == ".exr") return make_exr_writer(path, info);
  if (ending == ".npz") return make_npz_writer(path, info);
  throw InputError(fmt::format("{}: ending '{}'; accepted: .exr, .npz", path.string(),
                               path.extension().string()));
}

}  // namespace pellucid::compare
