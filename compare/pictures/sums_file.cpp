// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/sums_file.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

/// An OpenEXR file that appears whole or not at all.
class ExrFile {
 public:
  ExrFile(const fs::path& path, ImageSpec spec) : path_(checked(path)), file_(path) {
    // Otherwise the file holds the time of writing, and equal pictures give unequal files.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    output_ = OIIO::ImageOutput::create(file_.temporary().string());
    if (!output_) fail(OIIO::geterror());
    check(output_->open(file_.temporary().string(), spec));
  }

  OIIO::ImageOutput& output() { return *output_; }

  /// What a call of the library returned.
  void check(bool done) {
    if (!done) fail(output_->geterror());
  }

  void commit() {
    check(output_->close());
    file_.commit();
  }

 private:
  static const fs::path& checked(const fs::path& path) {
    const std::string ending = path.extension().string();
    if (ending != ".exr")
      throw InputError(fmt::format("{}: ending '{}'; accepted: .exr", path.string(), ending));
    return path;
  }

  [[noreturn]] void fail(std::string why) const {
    std::ranges::replace(why, '\n', ' ');
    throw WorkError(fmt::format("{}: cannot write the picture: {}", path_.string(), why));
  }

  fs::path path_;
  OutputFile file_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

// In the order of ImageSpec::channelnames.
enum DeepChannel { red, green, blue, alpha, depth, importance, object, primitive };

ImageSpec deep_spec(int width, int height) {
  ImageSpec spec(width, height, 8, TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A", "Z", "importance", "object", "primitive"};
  spec.channelformats.assign(8, TypeDesc::FLOAT);
  spec.channelformats[object] = spec.channelformats[primitive] = TypeDesc::UINT32;
  spec.alpha_channel = alpha;
  spec.z_channel = depth;
  spec.deep = true;
  spec.attribute("compression", "zips");
  return spec;
}

void set_samples(OIIO::DeepData& data, int x, const groundtruth::RaySums& ray) {
  for (int k = 0; k < int(ray.layers.size()); ++k) {
    const groundtruth::RayLayer& layer = ray.layers[k];
    for (int c = 0; c < 3; ++c)
      data.set_deep_value(x, red + c, k, float(layer.opacity * layer.color[c]));
    data.set_deep_value(x, alpha, k, float(layer.opacity));
    data.set_deep_value(x, depth, k, float(layer.depth));
    data.set_deep_value(x, importance, k, float(layer.importance));
    data.set_deep_value(x, object, k, layer.object);
    data.set_deep_value(x, primitive, k, layer.primitive);
  }
}

}  // namespace

void write_sums(const fs::path& path, const Raster<groundtruth::PixelSums>& sums) {
  static_assert(sizeof(groundtruth::PixelSums) == 7 * sizeof(float));
  ImageSpec spec(sums.width, sums.height, 7, TypeDesc::FLOAT);
  spec.channelnames = {"layers", "coverage", "transmittance", "importance_sum", "optical_depth",
                       "near",   "far"};
  spec.attribute("compression", "zip");
  ExrFile file(path, spec);
  file.check(file.output().write_image(TypeDesc::FLOAT, sums.pixels.data()));
  file.commit();
}

void write_deep(const fs::path& path, int width, int height,
                const std::function<std::vector<groundtruth::RaySums>(int y)>& row) {
  const ImageSpec spec = deep_spec(width, height);
  ExrFile file(path, spec);
  for (int y = 0; y < height; ++y) {
    const std::vector<groundtruth::RaySums> rays = row(y);
    OIIO::DeepData data;
    data.init(width, spec.nchannels, spec.channelformats, spec.channelnames);
    for (int x = 0; x < width; ++x) data.set_samples(x, int(rays[x].layers.size()));
    for (int x = 0; x < width; ++x) set_samples(data, x, rays[x]);
    file.check(file.output().write_deep_scanlines(y, y + 1, 0, data));
  }
  file.commit();
}

}  // namespace pellucid::compare
