// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::geometry {

/// This is the index of what is not named.
constexpr std::uint32_t obj_none = ~0u;

/// An ObjCorner is one of a face or of a line, by the indices of what is listed, from 0; obj_none
/// where it names none.
struct ObjCorner {
  std::uint32_t position = obj_none, texture = obj_none, normal = obj_none;
};

/// Rows holds rows of values, such as the corners of faces: those of all, and where those of each
/// end.
template <class Value>
struct Rows {
  std::vector<Value> values;
  std::vector<std::size_t> ends{0};

  std::size_t count() const { return ends.size() - 1; }
  std::span<const Value> row(std::size_t i) const {
    return std::span(values).subspan(ends[i], ends[i + 1] - ends[i]);
  }
};

/// An ObjElements holds faces, or lines, and the material of each as an index of
/// ObjDocument::materials.
struct ObjElements {
  Rows<ObjCorner> corners;
  std::vector<std::uint32_t> materials;
};

/// An ObjDocument is what the statements of an .obj file list, in their order.
struct ObjDocument {
  /// A Library is a statement mtllib: names of files, and the number of its line, from 1.
  struct Library {
    std::string names;
    std::size_t line = 0;
  };

  std::filesystem::path path;
  std::vector<Vec3> positions;
  std::vector<Rgba> colors;  // of the positions; none when no vertex has one
  std::vector<Vec3> normals;
  Rows<double> textures;  // one to three numbers each
  ObjElements faces, lines;
  std::vector<std::string> materials;  // that usemtl names, each once
  std::vector<Library> libraries;
  std::vector<std::string> remarks;  // what is read in one of two ways, or left out
};

/// Reads the statements of an .obj file. Throws InputError "FILE:LINE: …" for a number that is none
/// and for an index of what is listed nowhere.
ObjDocument read_obj_document(const std::filesystem::path& path);

}  // namespace pellucid::geometry
