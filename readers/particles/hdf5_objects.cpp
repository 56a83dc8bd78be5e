// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/particles/hdf5_objects.h"

#include <array>

namespace pellucid::readers {
namespace {

bool are_numbers(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

bool is_elsewhere(hid_t data_set) {
  const Hdf5Object kept(H5Dget_create_plist(data_set), H5Pclose);
  return H5Pget_layout(kept.id()) == H5D_VIRTUAL || H5Pget_external_count(kept.id()) > 0;
}

}  // namespace

std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  H5G_info_t info{};
  if (H5Gget_info(group, &info) < 0) return names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_of = [&](char* text, std::size_t size) {
      return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT);
    };
    const ssize_t length = name_of(nullptr, 0);
    if (length <= 0) continue;
    std::string name(std::size_t(length), '\0');
    name_of(name.data(), name.size() + 1);
    H5L_info_t link{};
    const bool found = H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) >= 0;
    if (found && link.type != H5L_TYPE_EXTERNAL) names.push_back(std::move(name));
  }
  return names;
}

std::optional<Hdf5Numbers> open_numbers(hid_t group, const std::string& name) {
  Hdf5Object object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object || H5Iget_type(object.id()) != H5I_DATASET) return std::nullopt;
  const Hdf5Object type(H5Dget_type(object.id()), H5Tclose);
  const Hdf5Object space(H5Dget_space(object.id()), H5Sclose);
  const int dimensions = H5Sget_simple_extent_ndims(space.id());
  if (!are_numbers(type.id()) || dimensions < 1 || dimensions > 2) return std::nullopt;
  std::array<hsize_t, 2> size{0, 1};
  H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
  const bool elsewhere = is_elsewhere(object.id());
  return Hdf5Numbers{std::move(object), size[0], size[1], elsewhere};
}

std::optional<std::vector<double>> read_numbers(const Hdf5Numbers& numbers) {
  std::vector<double> values(numbers.rows * numbers.components);
  const herr_t result =
      H5Dread(numbers.object.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  if (result < 0) return std::nullopt;
  return values;
}

std::vector<double> attribute_numbers(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return {};
  const Hdf5Object attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Object type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Object space(H5Aget_space(attribute.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (!are_numbers(type.id()) || count <= 0) return {};
  std::vector<double> values(static_cast<std::size_t>(count));
  if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) < 0) return {};
  return values;
}

}  // namespace pellucid::readers
