// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// OpenEXR files as they are written here: scan lines, 32-bit channels, ZIP. They hold no time of
// writing, so that equal pictures give equal files.

#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfPixelType.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "compare/pictures/picture_text.h"

namespace pellucid::compare {

/// An ExrStream is a stream that OpenEXR writes to. Its functions, but tellp(), throw WorkError
/// when the stream fails.
class ExrStream : public Imf::OStream {
 public:
  /// The name is the file's in messages.
  ExrStream(std::ostream& stream, const std::filesystem::path& name)
      : OStream(name.c_str()), stream_(stream) {}

  void write(const char bytes[], int count) override;
  std::uint64_t tellp() override;
  void seekp(std::uint64_t position) override;

 private:
  void check() const;
  std::ostream& stream_;
};

/// Returns how many threads OpenEXR may compress with: as many as TBB has.
int exr_threads();

/// Returns an OpenEXR file of `width` × `height` pixels, row 0 on top. Each pixel is a value of
/// every channel, 4 bytes of `type`, in the order of `channels`; the texts are attributes. Throws
/// WorkError that names `path`.
std::string encode_exr(const std::filesystem::path& path, int width, int height,
                       const std::vector<std::string>& channels, Imf::PixelType type,
                       const void* pixels, const PictureText& text);

}  // namespace pellucid::compare
