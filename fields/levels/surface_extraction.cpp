// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/surface_extraction.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"

namespace pellucid::fields {
namespace {

constexpr double most_samples = 0x1p28;

/// Heights of a field above a value; NaN where it has none.
struct Lattice {
  Vec3 origin;
  double width;
  std::array<int, 3> size;
  vtkNew<vtkFloatArray> samples;
};

void sample(const LevelField& field, double value, Lattice& lattice) {
  const Box3 bounds = field.bounds();
  lattice.origin = bounds.min;
  lattice.width = field.levels().front().width;
  double count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    // The last sample may lie beyond the end, where the field has no value.
    const double cells = std::ceil((bounds.max[axis] - bounds.min[axis]) / lattice.width - 1e-9);
    count *= cells + 1;
    if (count > most_samples)
      throw InputError(fmt::format(
          "its surface cannot be extracted: the finest width {} fills its bounds with over 2^28 "
          "samples",
          lattice.width));
    lattice.size[std::size_t(axis)] = int(cells) + 1;
  }
  const int nx = lattice.size[0], ny = lattice.size[1], nz = lattice.size[2];
  lattice.samples->SetNumberOfValues(vtkIdType(count));
  float* samples = lattice.samples->GetPointer(0);
  parallel_for(0, nz, [&](int k) {
    float* row = samples + std::size_t(k) * std::size_t(nx) * std::size_t(ny);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        Vec3 x = lattice.origin + lattice.width * Vec3(i, j, k);
        // Rounding puts no sample beyond the field's end.
        for (int axis = 0; axis < 3; ++axis)
          if (std::abs(x[axis] - bounds.max[axis]) < 1e-6 * lattice.width)
            x[axis] = bounds.max[axis];
        const auto height = field.height(x, value);
        *row++ = height ? float(*height) : std::numeric_limits<float>::quiet_NaN();
      }
  });
}

/// Newton's method along the gradient; x where it does not come closer.
Vec3 onto_surface(const LevelField& field, double value, const Vec3& x, double width) {
  Vec3 best = x, y = x;
  double least = std::abs(field.height(x, value).value_or(0));
  for (int i = 0; i < 4 && least > 0; ++i) {
    const auto height = field.height(y, value);
    const auto g = field.gradient(y);
    if (!height || !g || !(glm::dot(*g, *g) > 0)) break;
    y -= *height / glm::dot(*g, *g) * *g;
    if (glm::length(y - x) > width) break;
    const auto next = field.height(y, value);
    if (!next || !(std::abs(*next) < least)) break;
    least = std::abs(*next);
    best = y;
  }
  return best;
}

vtkNew<vtkPolyData> contour(const Lattice& lattice) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(lattice.size.data());
  image->SetSpacing(lattice.width, lattice.width, lattice.width);
  image->SetOrigin(lattice.origin.x, lattice.origin.y, lattice.origin.z);
  image->GetPointData()->SetScalars(lattice.samples);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(edges->GetOutput());
  return surface;
}

}  // namespace

ExtractedSurface extract_surface(const LevelField& field, double value) {
  Lattice lattice;
  sample(field, value, lattice);
  const vtkNew<vtkPolyData> surface = contour(lattice);
  const std::size_t count = std::size_t(surface->GetNumberOfPoints());
  ExtractedSurface out;
  out.positions.resize(count);
  out.normals.resize(count);
  std::vector<std::uint8_t> defined(count);
  parallel_for(std::size_t(0), count, [&](std::size_t i) {
    std::array<double, 3> x;
    surface->GetPoints()->GetPoint(vtkIdType(i), x.data());
    const Vec3 vertex(x[0], x[1], x[2]);
    // On an edge of the lattice to where the field has no value it is not a number.
    defined[i] = !glm::any(glm::isnan(vertex));
    if (!defined[i]) return;
    out.positions[i] = onto_surface(field, value, vertex, lattice.width);
    const Vec3 gradient = field.gradient(out.positions[i]).value_or(Vec3(0));
    const double size = glm::length(gradient);
    out.normals[i] = size > 0 ? gradient / size : Vec3(0, 0, 1);
  });
  const auto cells =
      vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    const vtkIdType* ids = nullptr;
    vtkIdType corners = 0;
    cells->GetCurrentCell(corners, ids);
    if (!defined[ids[0]] || !defined[ids[1]] || !defined[ids[2]]) continue;
    out.triangles.push_back({std::uint32_t(ids[0]), std::uint32_t(ids[1]), std::uint32_t(ids[2])});
  }
  return out;
}

}  // namespace pellucid::fields
