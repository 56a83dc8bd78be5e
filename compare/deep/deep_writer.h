// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Deep pictures as files: .exr for programs that composite, .npz for NumPy.

#include <filesystem>
#include <memory>

#include "compare/deep/deep_info.h"
#include "compare/deep/deep_row.h"

namespace pellucid::compare {

/// A DeepWriter takes a deep picture row by row, from the top, and keeps few of them in memory. The
/// file appears with commit(), whole. Functions throw WorkError when the disk is full.
class DeepWriter {
 public:
  virtual ~DeepWriter() = default;
  virtual void add(const DeepRow& row) = 0;
  virtual void commit() = 0;
};

/// Returns the writer for the path's ending.
///
/// .exr: a deep scan-line file of OpenEXR, compressed (ZIPS). A sample per crossing, front to back,
/// of R, G, B (multiplied by alpha), A, Z (view depth, world units) and importance, 32-bit float;
/// object and primitive, 32-bit integers; and the exact doubles of deep_channels.h.
///
/// .npz: a compressed archive of arrays, named and shaped as Python's Scene.deep() has them, and
/// `shape` (height, width) and `info`, text_of() the info. The arrays lie beside the file, as long
/// as it is being written, uncompressed and without a name.
///
/// Throws InputError for another ending or a folder that cannot be written.
std::unique_ptr<DeepWriter> make_deep_writer(const std::filesystem::path& path,
                                             const DeepInfo& info);

}  // namespace pellucid::compare
