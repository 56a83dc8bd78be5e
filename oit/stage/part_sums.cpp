// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/part_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/error.h"

namespace pellucid::oit {
namespace {

using scene::SumPlane;
using scene::SumPlanes;
using Numbers = SumTarget::Numbers;

int channels_of(GLenum format) {
  switch (format) {
    case GL_R32F:
    case GL_R32UI:
      return 1;
    case GL_RG32F:
      return 2;
    default:
      return 4;
  }
}

/// How OpenGL takes and gives the texels of a target.
struct Transfer {
  GLenum format, type;
};

Transfer transfer_of(const SumTarget& target) {
  if (target.numbers != Numbers::floats) return {GL_RED_INTEGER, GL_UNSIGNED_INT};
  constexpr GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return {formats[channels_of(target.texture->format()) - 1], GL_FLOAT};
}

// What OpenGL gives lies in the floats' place as 32 bits each.
static_assert(sizeof(float) == sizeof(std::uint32_t));

void from_texels(Numbers numbers, std::vector<float>& values) {
  if (numbers != Numbers::counts) return;
  for (float& value : values) value = float(std::bit_cast<std::uint32_t>(value));
}

void to_texels(Numbers numbers, std::vector<float>& values) {
  if (numbers != Numbers::counts) return;
  constexpr float most = 0x1p24f;  // counts are exact up to here
  for (float& value : values)
    value = std::bit_cast<float>(value > 0 ? std::uint32_t(std::min(value, most)) : 0u);
}

void clear(const SumTarget& target) {
  target.numbers == Numbers::floats ? target.texture->clear_floats(0) : target.texture->clear(0);
}

std::string plane_name(const SumTarget& target, int round, int layer) {
  return fmt::format("{} {}.{}", target.name, round, layer);
}

std::size_t values_of(const SumTarget& target) {
  const Texture& texture = *target.texture;
  return std::size_t(texture.width()) * std::size_t(texture.height()) *
         std::size_t(channels_of(texture.format()));
}

int planes_of(const SumTarget& target) { return std::max(target.texture->layers(), 1); }

void read(const SumTarget& target, int round, SumPlanes& planes) {
  const Texture& texture = *target.texture;
  const auto [format, type] = transfer_of(target);
  for (int layer = 0; layer < planes_of(target); ++layer) {
    SumPlane plane{plane_name(target, round, layer), target.combine, channels_of(texture.format()),
                   std::vector<float>(values_of(target))};
    texture.read_layer(layer, format, type, plane.values.size() * sizeof(float),
                       plane.values.data());
    from_texels(target.numbers, plane.values);
    planes.push_back(std::move(plane));
  }
}

/// Takes the planes of a target from the front. They come from files, which may lie.
void write(const SumTarget& target, int round, std::span<const SumPlane>& planes) {
  const auto [format, type] = transfer_of(target);
  for (int layer = 0; layer < planes_of(target); ++layer, planes = planes.subspan(1)) {
    const std::string name = plane_name(target, round, layer);
    if (planes.empty() || planes[0].name != name || planes[0].values.size() != values_of(target))
      throw InputError(fmt::format(
          "the sums have no '{}' of this picture; accepted: those of its method, by this build",
          name));
    std::vector<float> values = planes[0].values;
    to_texels(target.numbers, values);
    target.texture->write_layer(layer, format, type, values.data());
  }
}

}  // namespace

PartSums::PartSums(Stage& stage, SummingMethod& method, const Texture& picture,
                   const Framebuffer& target)
    : stage_(stage), method_(method), picture_(picture), target_(target) {
  if (!stage.scene().samples.is_center())
    throw InputError(fmt::format("samples: the scene takes {}; accepted for sums of parts: 1",
                                 scene::describe(stage.scene().samples)));
  method.check_parts();
}

PartSums::Rounds PartSums::rounds_of(int phase) const {
  if (method_.rounds_are_apart()) return {0, method_.rounds()};
  return {phase, phase + 1};
}

Frame PartSums::begin() const {
  stage_.make_current();
  stage_.sample_at(Vec2(0.5));
  stage_.draw_opaque_context();
  return {stage_, picture_, target_};
}

void PartSums::take(int phase, const SumPlanes& totals, Frame& frame) const {
  const auto [first, end] = rounds_of(phase);
  std::span<const SumPlane> planes(totals);
  for (int round = first; round < end; ++round) {
    for (const SumTarget& target : method_.targets(round)) write(target, round, planes);
    method_.close(round, frame);
  }
}

SumPlanes PartSums::sum(int phase, std::span<const SumPlanes> totals) {
  assert(totals.size() == std::size_t(phase));
  Frame frame = begin();
  for (int earlier = 0; earlier < phase; ++earlier)
    take(earlier, totals[std::size_t(earlier)], frame);
  SumPlanes planes;
  const auto [first, end] = rounds_of(phase);
  for (int round = first; round < end; ++round) {
    // Where no fragment comes a method may leave what was there, if it does not look at it.
    for (const SumTarget& target : method_.targets(round)) clear(target);
    method_.sum(round, frame);
    for (const SumTarget& target : method_.targets(round)) read(target, round, planes);
  }
  return planes;
}

Image PartSums::composite(std::span<const SumPlanes> totals) {
  if (totals.size() != std::size_t(phases()))
    throw InputError(fmt::format("sums of {} phases; accepted: of {}", totals.size(), phases()));
  Frame frame = begin();
  for (int phase = 0; phase < phases(); ++phase) take(phase, totals[std::size_t(phase)], frame);
  method_.composite(frame);
  return frame.read_picture();
}

Image PartSums::behind() {
  stage_.make_current();
  stage_.sample_at(Vec2(0.5));
  stage_.draw_opaque_context();
  return stage_.behind();
}

}  // namespace pellucid::oit
