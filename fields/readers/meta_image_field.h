// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"

namespace pellucid::fields {

struct FileOptions;

/// Raw samples described by a MetaImage header, the text format of ITK and MetaIO: .mhd names a
/// file of raw data, .mha holds them behind the header. Read here: NDims 3, DimSize, ElementType
/// MET_FLOAT or MET_DOUBLE, ElementNumberOfChannels 3, ElementSpacing, Offset (Position, Origin),
/// BinaryDataByteOrderMSB (ElementByteOrderMSB), ElementDataFile. Refused: compressed data, turned
/// axes. It has one array, whose name is "velocity".
std::unique_ptr<VectorField> read_meta_image_field(const std::filesystem::path& path,
                                                   const FileOptions& options);

}  // namespace pellucid::fields
