// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellucid::readers {

/// An Hdf5Object owns an object that HDF5 has opened, or nothing where it could not.
class Hdf5Object {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Object(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Object(Hdf5Object&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Object& operator=(Hdf5Object&&) = delete;
  ~Hdf5Object() {
    if (id_ >= 0) close_(id_);
  }

  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Returns the names of a group's links, in alphabetical order; of those that lead into other files
/// nothing.
std::vector<std::string> names_in(hid_t group);

/// An Hdf5Numbers is a data set of numbers, `rows` × `components`.
struct Hdf5Numbers {
  Hdf5Object object;
  hsize_t rows = 0, components = 1;
  bool elsewhere = false;  // its numbers are kept in other files
};

/// Opens the data set of this name in a group; nothing where there is none, or it holds no numbers,
/// or has more than two dimensions.
std::optional<Hdf5Numbers> open_numbers(hid_t group, const std::string& name);

/// Reads all numbers of a data set, row by row; nothing where HDF5 cannot.
std::optional<std::vector<double>> read_numbers(const Hdf5Numbers& numbers);

/// Returns the numbers of an object's attribute; none where there is no such.
std::vector<double> attribute_numbers(hid_t object, const std::string& name);

}  // namespace pellucid::readers
