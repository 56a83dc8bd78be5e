#include "scene/dataset.h"

#include "core/names.h"
#include "scene/datasets/fibres.h"
#include "scene/datasets/flow_lines.h"
#include "scene/datasets/flow_surfaces.h"
#include "scene/datasets/point_clouds.h"
#include "scene/datasets/stack.h"

namespace pellucid {

std::span<const DatasetRow> datasets() {
  static const DatasetRow rows[] = {
      stack_dataset(),     dark_sky_dataset(), ctbl_dataset(),       viscous_fingers_dataset(),
      benzene_dataset(),   dt_mri_dataset(),   bfs_dataset(),        icon_dataset(),
      trefoil_dataset(),   ecmwf_dataset(),    helicopter_dataset(), tornado_dataset(),
      delta_wing_dataset()};
  return rows;
}

Dataset make_dataset(std::string_view dataset, const Progress& progress) {
  const NameAndOptions named = parse_name_and_options(dataset);
  const DatasetRow& row = find_row("data set", named.name, datasets());
  return row.make(Parameters(row.name, row.parameters, named.options), progress);
}

}  // namespace pellucid
