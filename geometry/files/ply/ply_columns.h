// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply/ply_format.h"

namespace pellucid::geometry::ply {

/// Throws InputError where the element cannot be as long as the header says: every value takes at
/// least one byte, and nothing that a header claims sizes an allocation unchecked.
void check_count(const Reader& reader, const Element& element);

/// Reads the length of a list, which a file may write as any number type. Throws InputError for
/// what is no whole number from 0 on.
std::uint64_t list_length(Reader& reader, const Property& property);

/// Passes over a value or a list, or over all records of an element.
///@{
void skip(Reader& reader, const Property& property);
void skip(Reader& reader, const Element& element);
///@}

/// Columns are the numbers of an element's records by name, colours by their channels; lists are
/// none of them.
class Columns {
 public:
  explicit Columns(const Element& element);

  /// Reads the value of a property, by its number, which is no list.
  void read(Reader& reader, const Property& property, std::size_t number);
  VertexAttributes take() { return std::move(values_); }

 private:
  struct Column {
    std::vector<double>* values = nullptr;  // none: of a list
    double scale = 1;
  };
  VertexAttributes values_;
  std::vector<Column> columns_;
};

/// Returns the columns of all records of an element; its lists are passed over.
VertexAttributes read_columns(Reader& reader, const Element& element);

}  // namespace pellucid::geometry::ply
