// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare_inputs.h"

#include <fmt/format.h>

#include "compare/pictures/image_file.h"
#include "compare/report/crop.h"
#include "core/error.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

template <class A, class B>
bool of_one_size(const Raster<A>& a, const Raster<B>& b) {
  return a.width == b.width && a.height == b.height;
}

template <class T>
void check_size(const std::string& what, const Raster<T>& raster, const Image& reference) {
  if (!of_one_size(raster, reference))
    throw InputError(fmt::format("{}: {}×{} pixels; accepted: {}×{} as the reference", what,
                                 raster.width, raster.height, reference.width, reference.height));
}

std::optional<compare::Mask> read_mask(const fs::path& file, const Image& reference) {
  if (file.empty()) return std::nullopt;
  compare::Mask mask = compare::mask_of(compare::read_image(file));
  check_size(file.string(), mask, reference);
  if (compare::count(mask) == 0)
    throw InputError(fmt::format(
        "{}: no pixel counts; accepted: a mask with some red, green or blue of 0.5 or more",
        file.string()));
  return mask;
}

/// Those that were named must fit; those that lie beside a picture, as a study writes them, are
/// taken if they do.
std::optional<CountImage> read_layers(const fs::path& named, const fs::path& picture,
                                      const Image& reference) {
  if (!named.empty()) {
    CountImage layers = compare::read_counts(named);
    check_size(named.string(), layers, reference);
    return layers;
  }
  const fs::path beside = fs::path(picture).replace_extension(".layers.exr");
  if (!fs::exists(beside)) return std::nullopt;
  CountImage layers = compare::read_counts(beside);
  return of_one_size(layers, reference) ? std::optional(std::move(layers)) : std::nullopt;
}

void crop(CompareInputs& inputs, const compare::Crop& to) {
  compare::require_inside(to, inputs.reference.width, inputs.reference.height);
  inputs.reference = compare::cut(inputs.reference, to);
  inputs.test = compare::cut(inputs.test, to);
  if (inputs.mask) inputs.mask = compare::cut(*inputs.mask, to);
  if (inputs.layers) inputs.layers = compare::cut(*inputs.layers, to);
  if (inputs.test_layers) inputs.test_layers = compare::cut(*inputs.test_layers, to);
  if (inputs.mask && compare::count(*inputs.mask) == 0)
    throw InputError("--crop and --mask: no pixel of the mask counts within the crop");
}

}  // namespace

compare::PairRegions CompareInputs::regions() const {
  return {mask ? &*mask : nullptr, layers ? &*layers : nullptr,
          test_layers ? &*test_layers : nullptr};
}

CompareInputs read_inputs(const CompareFiles& files) {
  CompareInputs inputs;
  compare::PictureRead reference = compare::read_picture(files.reference);
  compare::PictureRead test = compare::read_picture(files.test);
  inputs.have_alpha = reference.has_alpha && test.has_alpha;
  inputs.reference = std::move(reference.image);
  inputs.test = std::move(test.image);
  check_size(
      fmt::format("{} against {}: test picture", files.test.string(), files.reference.string()),
      inputs.test, inputs.reference);
  inputs.mask = read_mask(files.mask, inputs.reference);
  inputs.layers = read_layers(files.layers, files.reference, inputs.reference);
  inputs.test_layers = read_layers(files.test_layers, files.test, inputs.reference);
  if (!files.crop.empty())
    crop(inputs, {files.crop[0], files.crop[1], files.crop[2], files.crop[3]});
  return inputs;
}

}  // namespace pellucid::app
