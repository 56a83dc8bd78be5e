// SPDX-License-Identifier: GPL-3.0-or-later
// A data set as blocks, and the geometry and the field that are made of it.

#include <vtkDataSet.h>

#include "fields/readers/vtk_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/block_file.h"
#include "fuzz/support/use_field.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/vtk_geometry.h"
#include "readers/vtk/data_set_blocks.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt_blocks({data, size}, [](const Blocks& blocks) {
    const vtkSmartPointer<vtkDataSet> set = readers::data_set_of(blocks);
    fuzz::attempt("input", [&] { check_mesh("input", geometry::mesh_of(set)); });
    fuzz::attempt("input", [&] { check_vertices("input", geometry::lines_of(set)); });
    fuzz::attempt("input", [&] { check_vertices("input", geometry::points_of(set)); });
    for (const auto interpolation : {fields::Interpolation::linear, fields::Interpolation::c1})
      fuzz::attempt("input", [&] {
        fields::FileOptions options;
        options.interpolation = interpolation;
        fuzz::use(*fields::field_of(set, options, "input.vtk"));
      });
  });
  return 0;
}
