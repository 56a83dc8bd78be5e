// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/optical_depth/optical_depth_passes.h"

#include <utility>

#include "oit/gl/bindings.h"

namespace pellucid::oit {
namespace {

constexpr std::string_view color_sum_name = "weighted sums of colour";

}  // namespace

OpticalDepthPasses::OpticalDepthPasses(Stage& stage, const std::vector<Target>& coefficients,
                                       GeometryProgram weight, Program composite)
    : stage_(stage), weight_(std::move(weight)), composite_(std::move(composite)) {
  for (const Target& target : coefficients) {
    names_.push_back(target.name);
    coefficients_.push_back(stage.target(target.name, target.format, target.layers));
  }
  color_sum_ = stage.target(color_sum_name, GL_RGBA32F);
  color_sum_target_ = {stage.gl(), {{color_sum_}}};
}

std::vector<SumTarget> OpticalDepthPasses::targets(int round, SumTarget::Numbers numbers) const {
  if (round == 1) return {{color_sum_name, &color_sum_}};
  std::vector<SumTarget> targets;
  for (std::size_t i = 0; i < coefficients_.size(); ++i)
    targets.push_back({names_[i], &coefficients_[i], scene::Combine::add, numbers});
  return targets;
}

void OpticalDepthPasses::weight(Frame& frame) const {
  frame.step("weight", [&] {
    color_sum_target_.clear_all(0);
    stage_.draw_geometry({color_sum_target_, {Blend::add}, coefficient_images()}, weight_);
  });
}

void OpticalDepthPasses::composite(Frame& frame) const {
  const Resources textures{coefficients_[0].as_texture(bindings::coefficients_texture),
                           color_sum_.as_texture(bindings::color_sums_texture)};
  frame.step("composite", [&] {
    stage_.draw_screen({frame.picture(), {Blend::replace}, coefficient_images() + textures},
                       composite_);
  });
}

Resources OpticalDepthPasses::coefficient_images() const {
  Resources images;
  for (std::size_t i = 0; i < coefficients_.size(); ++i)
    images.add(coefficients_[i].as_image(bindings::coefficients_image + int(i)));
  return images;
}

GeometryProgram clamped_geometry_program(const Stage& stage, std::string_view fragment,
                                         Defines defines, double clamp,
                                         const FragmentOpacity& opacity) {
  GeometryProgram program = stage.geometry_program(fragment, std::move(defines), opacity);
  // A projection of the importance has none.
  program.set_if_used("clamp_alpha", float(clamp));
  return program;
}

}  // namespace pellucid::oit
