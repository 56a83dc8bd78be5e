// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::scene {

// Each is defined where its data are made.
const DatasetRow& stack_dataset();
const DatasetRow& dark_sky_dataset();
const DatasetRow& ctbl_dataset();
const DatasetRow& viscous_fingers_dataset();
const DatasetRow& benzene_dataset();
const DatasetRow& dt_mri_dataset();
const DatasetRow& bfs_dataset();
const DatasetRow& icon_dataset();
const DatasetRow& trefoil_dataset();
const DatasetRow& ecmwf_dataset();
const DatasetRow& helicopter_dataset();
const DatasetRow& tornado_dataset();
const DatasetRow& helicopter_forward_dataset();
const DatasetRow& tornado_lines_dataset();
const DatasetRow& tornado_particles_dataset();
const DatasetRow& delta_wing_dataset();
const DatasetRow& sphere_levels_dataset();

namespace {

std::string names_on_levels() {
  std::vector<std::string_view> names;
  for (const DatasetRow& row : datasets())
    if (row.on_levels) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::span<const DatasetRow> datasets() {
  static const DatasetRow rows[] = {stack_dataset(),
                                    dark_sky_dataset(),
                                    ctbl_dataset(),
                                    viscous_fingers_dataset(),
                                    benzene_dataset(),
                                    dt_mri_dataset(),
                                    bfs_dataset(),
                                    icon_dataset(),
                                    trefoil_dataset(),
                                    ecmwf_dataset(),
                                    helicopter_dataset(),
                                    helicopter_forward_dataset(),
                                    tornado_dataset(),
                                    tornado_lines_dataset(),
                                    tornado_particles_dataset(),
                                    delta_wing_dataset(),
                                    sphere_levels_dataset()};
  return rows;
}

Dataset make_dataset(std::string_view dataset, const Progress& progress) {
  const NameAndOptions named = parse_name_and_options(dataset);
  const DatasetRow& row = find_row("data set", named.name, datasets());
  return row.make(Parameters(row.name, row.parameters, named.options), progress);
}

VelocityLevels make_velocity_levels(std::string_view dataset, const Progress& progress) {
  const std::string name = parse_name_and_options(dataset).name;
  if (!find_row("data set", name, datasets()).on_levels)
    throw InputError(
        fmt::format("data set '{}': it has no levels; accepted: {}", name, names_on_levels()));
  return std::get<VelocityLevels>(make_dataset(dataset, progress));
}

}  // namespace pellucid::scene
