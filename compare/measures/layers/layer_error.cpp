// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/layers/layer_error.h"

#include <cassert>
#include <cmath>
#include <map>

namespace pellucid::compare {
namespace {

constexpr std::uint32_t alone = 16;  // numbers of layers up to this one are not joined
constexpr double classes_to_double = 4;

/// Classes are in the order of their numbers of layers.
int class_of(std::uint32_t layers) {
  if (layers <= alone) return int(layers);
  return int(alone) + 1 +
         int(std::floor(classes_to_double * std::log2(double(layers) / (alone + 1))));
}

struct Class {
  double pixels = 0, layers = 0, squares = 0;

  void add(std::uint32_t n, const Rgba& a, const Rgba& b) {
    ++pixels;
    layers += n;
    for (int c = 0; c < 3; ++c) squares += std::pow(double(b[c]) - a[c], 2);
  }
  double mean_layers() const { return layers / pixels; }
  double rmse() const { return std::sqrt(squares / (3 * pixels)); }
};

}  // namespace

void add_layer_error(const Image& reference, const CountImage& reference_layers,
                     CellMeasurement& measured) {
  assert(reference.pixels.size() == measured.image.pixels.size());
  assert(reference.pixels.size() == reference_layers.pixels.size());
  std::map<int, Class> classes;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    if (const std::uint32_t n = reference_layers.pixels[i]; n > 0)
      classes[class_of(n)].add(n, reference.pixels[i], measured.image.pixels[i]);
  if (classes.empty()) return;
  RowCurve curve{"layer error",
                 "",
                 "Error over the number of layers",
                 "layers in the reference",
                 "RMSE",
                 {},
                 {}};
  for (const auto& [key, of] : classes) {
    curve.x.push_back(of.mean_layers());
    curve.y.push_back(of.rmse());
  }
  measured.row.curves.push_back(std::move(curve));
}

}  // namespace pellucid::compare
