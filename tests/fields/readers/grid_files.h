// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "core/vec.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::fields {

using testing::TemporaryFolder;
using Velocity = std::function<Vec3(const Vec3&)>;

/// One way to write a velocity into a file: the text of each format as its specification has it,
/// without the libraries that read it. Samples lie on 5 × 6 × 7 points of grid_box, straight axes
/// or not as the kind allows.
struct GridKind {
  std::string_view name;
  std::string_view ending;
  bool single_precision;
  bool takes_c1;  // its samples lie along axes
  void (*write)(const std::filesystem::path&, const Velocity&);
};

/// How GoogleTest names a kind.
inline void PrintTo(const GridKind& kind, std::ostream* out) { *out << kind.name; }

inline const Box3 grid_box{Vec3(0, -1, 1), Vec3(2, 1, 4)};

std::span<const GridKind> grid_kinds();

std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Writes the grid kind's file of a velocity and returns its path.
std::filesystem::path write_grid(const TemporaryFolder& folder, const GridKind& kind,
                                 const Velocity& velocity);
const GridKind& grid_kind(std::string_view name);

/// An uncompressed .vti of `count` samples a side over [0, 1]³ in double.
void write_cube(const std::filesystem::path& path, int count, const Velocity& velocity);

}  // namespace pellucid::fields
