// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/optical_depth/optical_depth_passes.h"

#include <utility>

namespace pellucid::oit {

OpticalDepthPasses::OpticalDepthPasses(Stage& stage, const std::vector<Target>& coefficients,
                                       GeometryProgram weight, Program composite)
    : stage_(stage), weight_(std::move(weight)), composite_(std::move(composite)) {
  for (const Target& target : coefficients)
    coefficients_.push_back(stage.target(target.name, target.format, target.layers));
  color_sum_ = stage.target("weighted sums of colour", GL_RGBA32F);
  color_sum_target_ = {stage.gl(), {{color_sum_}}};
}

void OpticalDepthPasses::begin_sum(const Framebuffer& target) const {
  target.clear_all(0);
  stage_.begin_pass(target, {Blend::add});
}

void OpticalDepthPasses::weight_and_composite(Frame& frame) const {
  frame.step("weight", [&] { weight_colors(); });
  frame.step("composite", [&] { composite(frame.picture()); });
}

void OpticalDepthPasses::weight_colors() const {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i].bind_image(GLuint(i));
  begin_sum(color_sum_target_);
  stage_.draw_geometry(weight_);
}

void OpticalDepthPasses::composite(const Framebuffer& picture) const {
  coefficients_[0].bind(0);
  color_sum_.bind(1);
  stage_.begin_pass(picture, {Blend::replace});
  stage_.draw_screen(composite_);
}

GeometryProgram clamped_geometry_program(const Stage& stage, std::string_view fragment,
                                         Defines defines, double clamp,
                                         const FragmentOpacity& opacity) {
  GeometryProgram program = stage.geometry_program(fragment, std::move(defines), opacity);
  program.set("clamp_alpha", float(clamp));
  return program;
}

}  // namespace pellucid::oit
