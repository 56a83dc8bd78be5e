// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/netcdf_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/error.h"

namespace pellucid::readers {
namespace {

std::span<double> numbers_of(vtkDoubleArray& times) {
  return {times.GetPointer(0), std::size_t(times.GetNumberOfValues())};
}

vtkSmartPointer<vtkDoubleArray> array_of(const std::vector<double>& times) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double time : times) array->InsertNextValue(time);
  return array;
}

}  // namespace

vtkSmartPointer<vtkDoubleArray> ascending_times(vtkDoubleArray& times, const std::string& file) {
  std::vector<double> sorted;
  for (const double time : numbers_of(times)) {
    if (!std::isfinite(time))
      throw InputError(fmt::format("{}: one of its times is {}; accepted: numbers", file, time));
    sorted.push_back(time);
  }
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    throw InputError(
        fmt::format("{}: two of its times are {}; accepted: each time once", file, *twice));
  return array_of(sorted);
}

vtkSmartPointer<vtkDoubleArray> times_to_load(vtkDoubleArray& times, double time) {
  const auto all = numbers_of(times);
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto wait = [&](double one) { return one >= time ? one - time : never; };
  const auto wanted = std::ranges::min_element(all, {}, wait) - all.begin();
  std::vector<double> substitutes(all.size(), never);
  std::fill_n(substitutes.begin(), wanted, -never);
  return array_of(substitutes);
}

}  // namespace pellucid::readers
