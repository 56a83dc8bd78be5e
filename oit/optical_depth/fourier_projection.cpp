// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/optical_depth/fourier_projection.h"

#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// Two bands to a target, band 0 included.
int target_count(int bands) { return (bands + 2) / 2; }

// OpenGL promises 8 colour attachments: 15 bands in one pass.
constexpr int targets_per_pass = 8;

}  // namespace

const OptionTable<SeriesOptions>& series_options() {
  static const OptionTable<SeriesOptions> table{
      clamp_option(&SeriesOptions::clamp),
      choice("at", &SeriesOptions::at,
             {{"behind", SeriesValue::behind}, {"middle", SeriesValue::middle}},
             "where the series is taken to be at a fragment: behind it as in Eq. 15, or in the "
             "middle of its step, whither a series converges"),
      number("margin", &SeriesOptions::margin,
             {.min = 0,
              .max = 1,
              .unit = "depth ranges",
              .help = "what the series' period exceeds the depth range by on either side; at 0 the "
                      "nearest and the farthest depth are one and the same to it"}),
      choice("precision", &SeriesOptions::precision, {{"32", 32}, {"16", 16}}, "of a coefficient",
             "bits"),
      number("subset", &SeriesOptions::subset,
             {.min = 1,
              .max = 1e6,
              .unit = "primitives",
              .help = "project every n-th triangle, segment and point only, n-fold (section "
                      "5.5.3)"})};
  return table;
}

FourierTarget fourier_target(int bands, const SeriesOptions& options) {
  return {options.precision == 16 ? GLenum(GL_RGBA16F) : GLenum(GL_RGBA32F), target_count(bands)};
}

FourierProjection::FourierProjection(const Stage& stage, const Texture& coefficients, int bands,
                                     const SeriesOptions& options, const Defines& defines,
                                     const FragmentOpacity& opacity)
    : stage_(stage), coefficients_(coefficients), bands_(bands) {
  if (options.subset > 1) subset_ = stage.geometry().every(std::uint32_t(options.subset));
  for (int first = 0; first < target_count(bands); first += targets_per_pass)
    passes_.push_back(pass(first, options, defines, opacity));
}

FourierProjection::Pass FourierProjection::pass(int first_target, const SeriesOptions& options,
                                                Defines defines,
                                                const FragmentOpacity& opacity) const {
  const int targets = std::min(targets_per_pass, target_count(bands_) - first_target);
  defines.emplace_back("FIRST_BAND", 2 * first_target);
  defines.emplace_back("TARGETS", targets);
  defines.emplace_back("SUBSET", options.subset);
  return {
      {stage_.gl(), {{coefficients_, targets, first_target}}},
      fourier_program(stage_, oit_glsl::fourier_project_frag_glsl(), defines, options, opacity)};
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
                                const SeriesOptions& options, const FragmentOpacity& opacity) {
  GeometryProgram program =
      clamped_geometry_program(stage, fragment, std::move(defines), options.clamp, opacity);
  program.set("margin", float(options.margin));
  return program;
}

}  // namespace pellucid::oit
