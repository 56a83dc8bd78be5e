// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/geometry_program.h"

#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

struct ShapeShader {
  std::string_view (*text)();
  const char* define;
};

// By ShapeKind.
constexpr ShapeShader shape_shaders[] = {{oit_glsl::mesh_vert_glsl, "MESH"},
                                         {oit_glsl::ribbon_vert_glsl, "RIBBON"},
                                         {oit_glsl::disc_vert_glsl, "DISC"},
                                         {oit_glsl::solid_vert_glsl, "SPHERE"},
                                         {oit_glsl::solid_vert_glsl, "TUBE"},
                                         {oit_glsl::isosurface_vert_glsl, "ISOSURFACE"},
                                         {oit_glsl::isosurface_vert_glsl, "FADING_ISOSURFACE"}};

}  // namespace

GeometryProgram::GeometryProgram(const GlContext& context, std::span<const ShapeKind> kinds,
                                 const FragmentText& fragment, const Defines& defines,
                                 const Resources& resources)
    : resources_(resources) {
  for (const ShapeKind kind : kinds) {
    const ShapeShader& shape = shape_shaders[std::size_t(kind)];
    Defines all = defines;
    all.emplace_back(shape.define, 1);
    programs_[std::size_t(kind)].emplace(context, shape.text(), fragment, all);
  }
}

}  // namespace pellucid::oit
