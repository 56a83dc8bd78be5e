#include "scene/dataset.h"

#include "core/names.h"
#include "scene/datasets/stack.h"

namespace pellucid {

std::span<const DatasetRow> datasets() {
  static const DatasetRow rows[] = {stack_dataset()};
  return rows;
}

Dataset make_dataset(std::string_view dataset, const Progress& progress) {
  const NameAndOptions named = parse_name_and_options(dataset);
  const DatasetRow& row = find_row("data set", named.name, datasets());
  return row.make(Parameters(row.name, row.parameters, named.options), progress);
}

}  // namespace pellucid
