// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/options/option_table.h"
#include "core/parallel.h"
#include "fields/make_field.h"

namespace pellucid::scene {
namespace {

enum class Size { small, big };  // 0.9 or 7.1 million samples

struct SphereLevelsOptions {
  Size size = Size::small;
  int levels = 4;   // from the coarsest on
  double Re = 100;  // Reynolds number of the flow past a sphere of radius 1
  int rings = 0;    // vortex rings in the wake
};

const OptionTable<SphereLevelsOptions>& sphere_levels_options() {
  using Options = SphereLevelsOptions;
  static const OptionTable<Options> table{
      choice("size", &Options::size, {{"small", Size::small}, {"big", Size::big}},
             "small: 0.9 million samples; big: 7.1 million, half as far apart"),
      number("levels", &Options::levels,
             {.min = 1,
              .max = 4,
              .unit = "levels",
              .help = "from the coarsest on; 1: the same field at one resolution"}),
      number("Re", &Options::Re,
             {.min = 1e-3,
              .max = 1e3,
              .unit = "1",
              .help = "Reynolds number of the flow past a sphere of radius 1"}),
      number("rings", &Options::rings,
             {.min = 0,
              .max = 16,
              .unit = "rings",
              .help = "vortex rings in the wake, see the field shed-wake; 5 reach its end"})};
  return table;
}

/// From the coarsest to the finest, in units of the coarsest cell, so that cells of one level hold
/// whole cells of the next.
struct Nest {
  Vec3 min, max;
};
constexpr double coarsest_width = 0.25;
constexpr std::array<Nest, 4> nests{{{{-16, -12, -12}, {40, 12, 12}},
                                     {{-10, -8, -8}, {24, 8, 8}},
                                     {{-7, -6, -6}, {12, 6, 6}},
                                     {{-6, -5, -5}, {6, 5, 5}}}};

fields::VectorLevel sample(const fields::VectorField& field, const Nest& nest, double width) {
  fields::VectorLevel level;
  level.width = width;
  level.origin = coarsest_width * nest.min + 0.5 * width;
  for (int axis = 0; axis < 3; ++axis)
    level.size[std::size_t(axis)] =
        int(std::lround(coarsest_width * (nest.max[axis] - nest.min[axis]) / width));
  level.samples.resize(std::size_t(level.size[0]) * std::size_t(level.size[1]) *
                       std::size_t(level.size[2]));
  parallel_for(0, level.size[2], [&](int k) {
    const auto sampler = field.sampler();
    for (int j = 0; j < level.size[1]; ++j)
      for (int i = 0; i < level.size[0]; ++i) {
        Vec3 v(0);  // stays where the flow has no value: on the sphere's axis behind it
        if (sampler->velocity(level.world(Vec3(i, j, k)), 0, v) != fields::SampleStatus::ok)
          v = Vec3(0);
        level.samples[level.index(i, j, k)] = glm::vec3(v);
      }
  });
  return level;
}

Dataset make_sphere_levels(const Parameters& parameters, const Progress&) {
  const SphereLevelsOptions options = sphere_levels_options().read(parameters);
  const auto field = fields::make_field(
      fmt::format("shed-wake:Re={},rings={}", number_text(options.Re), options.rings));
  double width = options.size == Size::big ? coarsest_width / 2 : coarsest_width;
  VelocityLevels levels;
  for (int i = 0; i < options.levels; ++i, width /= 2)
    levels.push_back(sample(*field, nests[std::size_t(i)], width));
  return levels;
}

}  // namespace

// The flow past a sphere (the fields sphere and shed-wake) at the samples of nested levels, the
// finest around the sphere, each coarser one twice as coarse.
const DatasetRow& sphere_levels_dataset() {
  static const DatasetRow row{.name = "sphere-levels",
                              .title = "Velocity past a sphere on four nested resolutions",
                              .citation = "the fields sphere and shed-wake",
                              .parameters = sphere_levels_options().specs(),
                              .make = make_sphere_levels,
                              .on_levels = true};
  return row;
}

}  // namespace pellucid::scene
