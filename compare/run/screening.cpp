// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/screening.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/cells/measure_cell.h"
#include "compare/methods/surface_methods.h"
#include "compare/pictures/metrics.h"
#include "compare/pictures/picture_pair.h"

namespace pellucid::compare {
namespace {

bool beats(const SmallPicture& one, const SmallPicture& other, double margin) {
  return one.seconds * margin < other.seconds && one.rmse * margin <= other.rmse &&
         one.bytes <= other.bytes;
}

/// Optimized opacities are meant to differ from those of a reference that optimizes none, a surface
/// is integrated as long for a small picture, and a picture from elsewhere has one size.
bool can_be_screened(const MethodCall& call, const MethodCall& reference) {
  const auto is_its_row = [&](const scene::MethodRow& row) { return &row == call.row; };
  const bool is_meant_to_differ =
      call.row->promises.optimizes_opacity && !reference.row->promises.optimizes_opacity;
  return !call.given && !is_meant_to_differ && std::ranges::none_of(surface_methods(), is_its_row);
}

class Screening {
 public:
  Screening(const MethodCall& reference, const scene::Scene& scene, double size,
            const scene::RenderContext& context)
      : context_(context), scene_(scene) {
    scene_.width = std::max(1, int(std::lround(size * scene.width)));
    scene_.height = std::max(1, int(std::lround(size * scene.height)));
    reference_ = measure_cell(cell(reference), scene_, fixed_repeats(1), context).image;
  }

  /// Nothing of a call that fails.
  std::optional<SmallPicture> draw(const MethodCall& call) const {
    try {
      CellMeter meter(cell(call), scene_, context_);
      meter.time_once();
      const PicturePair pair(reference_, meter.image());
      const std::string rmse[]{"rmse"};
      return SmallPicture{call.text(), meter.seconds().front(),
                          compare_pair(pair, rmse).linear.of("rmse").value_or(NAN),
                          meter.row().total_bytes()};
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

 private:
  Cell cell(const MethodCall& call) const { return {{}, scene_.name, call}; }

  const scene::RenderContext& context_;
  scene::Scene scene_;
  Image reference_;
};

}  // namespace

std::vector<ScreenedCall> beaten(std::span<const SmallPicture> pictures, double size,
                                 double margin) {
  const auto is_beaten = [&](const SmallPicture& own) {
    return std::ranges::any_of(
        pictures, [&](const SmallPicture& other) { return beats(other, own, margin); });
  };
  std::vector<ScreenedCall> screened;
  for (const SmallPicture& own : pictures) {
    const SmallPicture* by = nullptr;
    for (const SmallPicture& other : pictures)
      if (beats(other, own, margin) && !is_beaten(other) && (!by || other.rmse < by->rmse))
        by = &other;
    if (by) screened.push_back({size, own, *by});
  }
  return screened;
}

std::vector<ScreenedCall> screen_calls(std::span<const MethodCall> calls,
                                       const MethodCall& reference, const scene::Scene& scene,
                                       const ScreenRule& rule, const scene::RenderContext& context,
                                       const std::function<void(const std::string&)>& tell) {
  std::vector<const MethodCall*> in;
  for (const MethodCall& call : calls)
    if (can_be_screened(call, reference)) in.push_back(&call);
  std::vector<ScreenedCall> screened;
  for (const double size : rule.sizes) {
    const Screening small(reference, scene, size, context);
    std::vector<SmallPicture> pictures;
    for (const MethodCall* call : in) {
      tell(fmt::format("{}, {} of the size", call->text(), size));
      if (auto picture = small.draw(*call)) pictures.push_back(std::move(*picture));
    }
    for (ScreenedCall& out : beaten(pictures, size, rule.margin)) {
      std::erase_if(in, [&](const MethodCall* call) { return call->text() == out.own.call; });
      screened.push_back(std::move(out));
    }
  }
  return screened;
}

}  // namespace pellucid::compare
