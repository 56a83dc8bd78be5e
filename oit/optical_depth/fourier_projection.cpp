// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/optical_depth/fourier_projection.h"

#include "oit/optical_depth/optical_depth_passes.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// Two bands to a target, band 0 included.
int target_count(int bands) { return (bands + 2) / 2; }

// OpenGL promises 8 colour attachments: 15 bands in one pass.
constexpr int targets_per_pass = 8;

}  // namespace

FourierTarget fourier_target(int bands, const Parameters& parameters) {
  return {parameters.integer("precision") == 16 ? GLenum(GL_RGBA16F) : GLenum(GL_RGBA32F),
          target_count(bands)};
}

FourierProjection::FourierProjection(const Stage& stage, const Texture& coefficients, int bands,
                                     const Parameters& parameters, const Defines& defines,
                                     const FragmentOpacity& opacity)
    : stage_(stage), coefficients_(coefficients), bands_(bands) {
  if (parameters.integer("subset") > 1)
    subset_ = stage.geometry().every(std::uint32_t(parameters.integer("subset")));
  for (int first = 0; first < target_count(bands); first += targets_per_pass)
    passes_.push_back(pass(first, parameters, defines, opacity));
}

FourierProjection::Pass FourierProjection::pass(int first_target, const Parameters& parameters,
                                                Defines defines,
                                                const FragmentOpacity& opacity) const {
  const int targets = std::min(targets_per_pass, target_count(bands_) - first_target);
  defines.emplace_back("FIRST_BAND", 2 * first_target);
  defines.emplace_back("TARGETS", targets);
  defines.emplace_back("SUBSET", parameters.integer("subset"));
  return {
      {stage_.gl(), {{coefficients_, targets, first_target}}},
      fourier_program(stage_, oit_glsl::fourier_project_frag_glsl(), defines, parameters, opacity)};
}

void FourierProjection::project() const {
  for (const Pass& pass : passes_) {
    pass.targets.clear_all(0);
    const oit::Pass adding(pass.targets, {Blend::add});
    subset_ ? stage_.draw_geometry(adding, pass.program, *subset_)
            : stage_.draw_geometry(adding, pass.program);
  }
}

GeometryProgram fourier_program(const Stage& stage, std::string_view fragment, Defines defines,
                                const Parameters& parameters, const FragmentOpacity& opacity) {
  GeometryProgram program =
      clamped_geometry_program(stage, fragment, std::move(defines), parameters, opacity);
  program.set("margin", float(parameters.real("margin")));
  return program;
}

}  // namespace pellucid::oit
