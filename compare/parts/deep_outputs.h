// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "compare/deep/deep_writer.h"
#include "compare/pictures/picture_text.h"
#include "core/raster.h"

namespace pellucid::compare {

/// DeepOutputs are the files that are made of a deep picture's rows as they come: the picture that
/// they composite to, the deep picture itself, or both. They appear with commit(), whole. The
/// picture of a part says of itself which one it is: "Part", "1/3".
class DeepOutputs {
 public:
  /// Takes where each is to be written; empty: not at all. Throws InputError for another ending of
  /// the deep picture than make_deep_writer() takes, or a folder that cannot be written.
  DeepOutputs(const DeepInfo& info, std::filesystem::path picture,
              const std::filesystem::path& deep);

  /// Takes row `y`; rows come from the top, each once.
  void take(int y, const DeepRow& row);
  /// Throws as write_image() and DeepWriter::commit() do.
  void commit();

  std::uint64_t crossings() const { return crossings_; }
  std::uint32_t max_layers() const { return max_layers_; }  // of a pixel

 private:
  Vec3 background_;
  PictureForm form_;
  std::filesystem::path picture_;
  Image image_;
  std::unique_ptr<DeepWriter> writer_;
  std::uint64_t crossings_ = 0;
  std::uint32_t max_layers_ = 0;
};

}  // namespace pellucid::compare
