// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pieces of one of VTK's XML files, or of several, have to have in common. VTK 9.1 asks
// for none of it, and reads something else.

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "readers/vtk/xml_tags.h"

namespace pellucid::readers {

/// Throws InputError, which names the file, where its pieces do not have the same arrays in one
/// order, or where the first cells of a kind stand in a piece behind one that has points.
void check_pieces(std::span<const XmlTag> tags, const std::filesystem::path& path);

/// DeclaredWidths are what a file of pieces says of all their arrays: how many numbers a tuple has.
class DeclaredWidths {
 public:
  /// The numbers of a tuple, by whether the array is of cells, and its name.
  using Widths = std::map<std::pair<bool, std::string>, double>;

  /// `tags` are those of the file of pieces, whose path has to outlive this.
  DeclaredWidths(std::span<const XmlTag> tags, const std::filesystem::path& path);

  /// Throws InputError, which names both files, where an array of a piece has another width: VTK
  /// would copy its numbers as if they were as many as are declared.
  void check_piece(std::span<const XmlTag> tags, const std::filesystem::path& piece) const;

 private:
  Widths widths_;
  const std::filesystem::path& path_;
};

}  // namespace pellucid::readers
