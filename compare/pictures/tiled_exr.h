// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenEXR/ImfTiledOutputFile.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "compare/pictures/exr_file.h"
#include "compare/pictures/picture_text.h"
#include "core/files/output_file.h"
#include "core/raster.h"

namespace pellucid::compare {

/// A TiledExr is a picture that is written rows by rows, from the top, and need not fit in the
/// memory: an OpenEXR file of tiles of `side` × `side` pixels, of which a viewer reads those that
/// it shows. Channels and texts are those of write_image(). It appears with commit(), whole.
/// Functions throw WorkError when the disk is full, the constructor also InputError as OutputFile
/// does.
class TiledExr {
 public:
  static constexpr int side = 256;

  TiledExr(const std::filesystem::path& path, int width, int height, const PictureForm& form);

  /// Writes the next rows: `side` of them, at the bottom those that are left.
  void add(const Image& rows);
  void commit();

 private:
  std::filesystem::path path_;
  OutputFile output_;
  std::ofstream out_;
  ExrStream stream_;
  std::optional<Imf::TiledOutputFile> file_;
  int written_ = 0;  // rows
};

}  // namespace pellucid::compare
