#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "oit/batch.h"
#include "oit/program.h"

namespace pellucid {

/// One fragment shader over the scene's shapes: a program for each kind that is there.
class GeometryProgram {
 public:
  GeometryProgram() = default;
  GeometryProgram(const GlContext& context, std::span<const ShapeKind> kinds,
                  std::string_view fragment, const Defines& defines);

  template <class T>
  void set(const char* name, const T& value) const {
    for (const auto& program : programs_)
      if (program) program->set(name, value);
  }
  const Program& of(ShapeKind kind) const { return *programs_[std::size_t(kind)]; }

 private:
  std::array<std::optional<Program>, shape_kinds.size()> programs_;
};

}  // namespace pellucid
