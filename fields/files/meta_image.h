// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "fields/files/meta_image_header.h"

namespace pellucid::fields {

/// A MetaImage is the text format of ITK and MetaIO for raw samples: .mhd names a file of raw data,
/// .mha holds them behind the header; both may be compressed (zlib).
struct MetaImage {
  MetaImageHeader header;
  std::string bytes;  // of all samples, unpacked, in the machine's byte order

  /// Returns the numbers, which have to be of T: those of a sample beside each other, x fastest.
  template <class T>
  std::span<const T> numbers() const {
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
};

/// Reads a MetaImage. Throws InputError, naming `path`, as read_meta_image_header() does, and for
/// data that are missing, damaged or not as many as the header says.
MetaImage read_meta_image(const std::filesystem::path& path);

}  // namespace pellucid::fields
