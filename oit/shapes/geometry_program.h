// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "oit/gl/program.h"
#include "oit/shapes/batch.h"

namespace pellucid::oit {

/// A FragmentOpacity changes the opacity of every fragment before a pass sees it, see
/// fragment.glsl: by nothing, or by the defines and the text that say how, with what these find
/// bound.
struct FragmentOpacity {
  Defines defines = {};
  std::string_view text = {};
  Resources resources = {};
};

/// A GeometryProgram is one fragment shader over the scene's shapes: a program for each kind that
/// is there.
class GeometryProgram {
 public:
  GeometryProgram() = default;
  GeometryProgram(const GlContext& context, std::span<const ShapeKind> kinds,
                  const FragmentText& fragment, const Defines& defines,
                  const Resources& resources = {});

  /// Set a uniform of all its programs, as Program does.
  template <class T>
  void set(std::string_view name, const T& value) const {
    for (const auto& program : programs_)
      if (program) program->set(name, value);
  }
  template <class T>
  void set_if_used(std::string_view name, const T& value) const {
    for (const auto& program : programs_)
      if (program) program->set_if_used(name, value);
  }
  /// Returns what it finds in any pass, as its FragmentOpacity says.
  const Resources& resources() const { return resources_; }
  const Program& of(ShapeKind kind) const { return *programs_[std::size_t(kind)]; }

 private:
  std::array<std::optional<Program>, shape_kinds.size()> programs_;
  Resources resources_;
};

}  // namespace pellucid::oit
