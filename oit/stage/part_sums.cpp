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
  for (float& value : values) value = std::bit_cast<float>(std::uint32_t(value));
}

void clear(const SumTarget& target) {
  target.numbers == Numbers::floats ? target.texture->clear_floats(0) : target.texture->clear(0);
}

int planes_of(const SumTarget& target) { return std::max(target.texture->layers(), 1); }

void read(const SumTarget& target, int round, SumPlanes& planes) {
  const Texture& texture = *target.texture;
  const auto [format, type] = transfer_of(target);
  for (int layer = 0; layer < planes_of(target); ++layer) {
    SumPlane plane{fmt::format("{} {}.{}", target.name, round, layer),
                   target.combine,
                   channels_of(texture.format()),
                   {}};
    plane.values.resize(std::size_t(texture.width()) * std::size_t(texture.height()) *
                        std::size_t(plane.channels));
    texture.read_layer(layer, format, type, plane.values.size() * sizeof(float),
                       plane.values.data());
    from_texels(target.numbers, plane.values);
    planes.push_back(std::move(plane));
  }
}

void write(const SumTarget& target, std::span<const SumPlane> planes) {
  const auto [format, type] = transfer_of(target);
  for (int layer = 0; layer < planes_of(target); ++layer) {
    std::vector<float> values = planes[std::size_t(layer)].values;
    assert(values.size() == std::size_t(target.texture->width()) *
                                std::size_t(target.texture->height()) *
                                std::size_t(channels_of(target.texture->format())));
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
  std::size_t next = 0;
  for (int round = first; round < end; ++round) {
    for (const SumTarget& target : method_.targets(round)) {
      write(target, std::span(totals).subspan(next, std::size_t(planes_of(target))));
      next += std::size_t(planes_of(target));
    }
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
    for (const SumTarget& target : method_.targets(round)) clear(target);
    method_.sum(round, frame);
    for (const SumTarget& target : method_.targets(round)) read(target, round, planes);
  }
  return planes;
}

Image PartSums::composite(std::span<const SumPlanes> totals) {
  assert(totals.size() == std::size_t(phases()));
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
