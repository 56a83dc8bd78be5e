// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/faults/given_faults.h"
#include "compare/run/entrants.h"
#include "compare/run/tune_entrants.h"
#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

constexpr int small_by = 4;             // a small picture has so many times fewer pixels on a side
constexpr std::size_t quick_times = 9;  // of a picture until so many seconds are spent on it:
constexpr double quick_seconds = 0.1;   // what delays a process for some ms hits not all of them
constexpr double small_part = 0.3;      // of the time for small pictures, and until
constexpr double drawing_part = 0.7;    // for whole ones; the rest is for the contenders
/// The others take longer than many a picture.
const std::string judged_by[]{"rmse", "ssim", "psnr", "max_error", "rmse_covered", "ssim_covered"};

class Tuning {
 public:
  explicit Tuning(const TuneRequest& request)
      : request_(request),
        scene_(scene::load_scene(request.scene, request.progress, request.view)) {
    if (request.opacities) {
      std::vector<MethodCall> calls = request.candidates;
      calls.push_back(request.reference);
      optimize_opacities(*request.opacities, request.context, scene_, further_samplings(calls));
    }
    small_ = scene_;
    small_.width = std::max(1, scene_.width / small_by);
    small_.height = std::max(1, scene_.height / small_by);
  }

  TuneOutcome run() {
    choose_entrants();
    draw_reference();
    draw_small();
    const TuneEstimate told = estimate();
    expected_seconds_ = told.seconds;
    if (request_.on_estimate) request_.on_estimate(told);
    for (std::size_t i = 0; i < entrants_.size(); ++i) enter(i);
    if (request_.cost == Cost::bytes)
      weigh(entrants_);
    else
      time_contenders(
          entrants_, request_.repeats, [&] { return is_over(); },
          [&](const Entrant& entrant) { tell(entrant.call.text()); });
    report(request_.progress, 1, "tuned");
    rank(std::move(entrants_), request_.cost, outcome_);
    return std::move(outcome_);
  }

 private:
  Cell cell(const MethodCall& call) const {
    return {request_.scene, scene_name(request_.scene), call};
  }
  /// Whether this part of the time is over.
  bool is_over(double part = 1) const {
    return request_.max_seconds && clock_.seconds() > part * *request_.max_seconds;
  }
  bool is_reference(const Entrant& entrant) const {
    return entrant.call.row == request_.reference.row &&
           entrant.call.parameters.all() == request_.reference.parameters.all();
  }
  void leave_out(const Entrant& entrant, std::string why, bool undecided = false) {
    outcome_.left_out.push_back({entrant.call.text(), std::move(why), undecided});
  }
  /// The part of the time that is expected has gone by.
  void tell(std::string_view what) const {
    const double part = expected_seconds_ > 0 ? clock_.seconds() / expected_seconds_ : 0;
    report(request_.progress, std::min(part, 0.99), what);
  }

  bool is_too_slow(Entrant& entrant);
  void choose_entrants();
  void draw_reference();
  void draw_small();
  TuneEstimate estimate() const;
  void enter(std::size_t index);
  void take_reference(Entrant& entrant);
  void draw(Entrant& entrant);
  void judge_draws(Entrant& entrant);
  void judge(const Image& image, Entrant& entrant);

  const TuneRequest& request_;
  Stopwatch clock_;
  scene::Scene scene_, small_;
  CellMeasurement reference_;
  std::optional<double> reference_small_;  // seconds of its small picture
  double expected_seconds_ = 0;            // of all the tuning; 0: not known yet
  std::vector<Entrant> entrants_;
  TuneOutcome outcome_;
};

void Tuning::choose_entrants() {
  for (std::size_t place = 0; place < request_.candidates.size(); ++place) {
    const MethodCall& call = request_.candidates[place];
    if (const auto why = why_left_out(call, request_.reference, scene_))
      outcome_.left_out.push_back({call.text(), *why});
    else
      entrants_.push_back({call, place});
  }
  if (entrants_.empty())
    throw InputError(
        fmt::format("{}: no candidate is left to compete: {}", request_.scene.string(),
                    outcome_.left_out.empty() ? "there is none" : outcome_.left_out.front().why));
}

void Tuning::draw_reference() {
  if (request_.max_seconds) expected_seconds_ = *request_.max_seconds;
  tell(request_.reference.text());
  reference_ = measure_cell(cell(request_.reference), scene_, fixed_repeats(1), request_.context);
  const auto& layers = reference_.layers.pixels;
  if (request_.bound.covered && std::ranges::all_of(layers, [](auto n) { return n == 0; }))
    throw InputError(fmt::format("--region covered: no pixel of {} is known to have a layer",
                                 request_.scene.string()));
  if (is_over(small_part)) return;
  reference_small_ =
      measure_cell(cell(request_.reference), small_, fixed_repeats(1), request_.context)
          .row.seconds.median;
}

/// Who fails is drawn in full all the same, first: its row says why. Who has no small picture yet
/// when its time is over comes last.
void Tuning::draw_small() {
  for (Entrant& entrant : entrants_) {
    if (is_over(small_part)) break;
    tell(entrant.call.text() + ", small");
    try {
      CellMeter meter(cell(entrant.call), small_, request_.context);
      meter.time_once();
      entrant.small_setup = meter.row().setup_seconds;
      entrant.small_seconds = meter.seconds().front();
    } catch (const std::exception&) {
      entrant.small_seconds = 0;
    }
  }
  std::ranges::stable_sort(entrants_, {}, [](const Entrant& entrant) {
    return entrant.small_seconds.value_or(std::numeric_limits<double>::infinity());
  });
}

/// The whole picture takes as many times as long as the small one as the reference's does, as long
/// as the reference's where there is no small one. Two of each, the first to warm up; then all
/// times of a handful of the fastest.
TuneEstimate Tuning::estimate() const {
  constexpr std::size_t handful = 4;
  const double of_reference = reference_.row.seconds.median;
  const double larger = std::clamp(of_reference / reference_small_.value_or(of_reference), 1.0,
                                   double(small_by * small_by));
  TuneEstimate estimate{entrants_.size(), clock_.seconds()};
  for (std::size_t i = 0; i < entrants_.size(); ++i) {
    const auto& small = entrants_[i].small_seconds;
    const double whole = small ? larger * *small : of_reference;
    estimate.seconds += entrants_[i].small_setup + 2 * whole;
    if (i < handful) estimate.seconds += request_.repeats * whole;
  }
  if (request_.max_seconds) estimate.seconds = std::min(estimate.seconds, *request_.max_seconds);
  return estimate;
}

/// Whether its small picture takes longer than the whole one of the fastest that is within the
/// bound.
bool Tuning::is_too_slow(Entrant& entrant) {
  if (request_.cost != Cost::seconds) return false;
  Entrant* best = nullptr;
  for (Entrant& other : entrants_)
    if (other.meter && (!best || other.least_seconds() < best->least_seconds())) best = &other;
  const double small = entrant.small_seconds.value_or(0);
  if (!best || small <= best->least_seconds()) return false;
  if (small <= hopeless * best->least_seconds()) {
    try {
      CellMeter meter(cell(entrant.call), small_, request_.context);
      if (!is_slower(meter, *best->meter, 1, [&] { return is_over(); })) return false;
    } catch (const std::exception&) {
      return false;  // drawn in full, it says why
    }
  }
  leave_out(entrant, fmt::format("its picture of 1/{} the size took {:.1f} ms, the whole one of "
                                 "another within the bound {:.1f} ms",
                                 small_by, 1e3 * small, 1e3 * best->least_seconds()));
  return true;
}

/// Draws the whole picture, unless it cannot win any more.
void Tuning::enter(std::size_t index) {
  Entrant& entrant = entrants_[index];
  if (is_over(drawing_part)) {
    if (is_reference(entrant)) return take_reference(entrant);
    return leave_out(entrant, "not drawn: the time was over", true);
  }
  if (is_too_slow(entrant)) return;
  tell(entrant.call.text());
  try {
    draw(entrant);
  } catch (const std::exception& error) {
    entrant.meter.reset();
    entrant.row = identity_row(cell(entrant.call));
    entrant.row.error = error.what();
    entrant.drawn = true;
    entrant.within = false;
  }
  if (request_.on_row) request_.on_row(entrant.row);
  keep_contenders(entrants_, [&] { return is_over(); });
}

/// The reference's picture is there and its time known: with it there is always an answer.
void Tuning::take_reference(Entrant& entrant) {
  entrant.row = reference_.row;
  entrant.row.parameters = identity_row(cell(entrant.call)).parameters;  // as this call has them
  entrant.of_reference = true;
  judge(reference_.image, entrant);
  if (request_.on_row) request_.on_row(entrant.row);
}

void Tuning::draw(Entrant& entrant) {
  entrant.meter = std::make_unique<CellMeter>(cell(entrant.call), scene_, request_.context);
  entrant.meter->time_once();
  entrant.row = entrant.meter->row();
  judge_draws(entrant);
  if (!entrant.within || request_.cost == Cost::bytes) return finish(entrant, fixed_repeats(1));
  // A second one at least, since chance may have delayed the first.
  for (double spent = 0;
       spent < quick_seconds && entrant.meter->seconds().size() < quick_times && !is_over();) {
    entrant.meter->time_once();
    spent += entrant.meter->seconds().back();
  }
}

/// A method of random numbers is within the bound by all of several draws, or chance would decide.
void Tuning::judge_draws(Entrant& entrant) {
  judge(entrant.meter->image(), entrant);
  if (!entrant.within) return;
  for (const Image& draw : entrant.meter->draws()) {
    judge(draw, entrant);
    if (!entrant.within) return;
  }
  if (!entrant.meter->draws().empty()) judge(entrant.meter->image(), entrant);
}

/// Compares the entrant's picture with the reference's.
void Tuning::judge(const Image& image, Entrant& entrant) {
  ResultRow& row = entrant.row;
  const CountImage* layers = reference_.layers.pixels.empty() ? nullptr : &reference_.layers;
  const PicturePair pair(reference_.image, image,
                         {.mask = nullptr, .reference_layers = layers, .test_layers = nullptr});
  row.metrics = compare_pair(pair, judged_by);
  if (entrant.call.given)
    row.given_faults = given_faults(reference_.image, image, scene_.background);
  entrant.drawn = true;
  entrant.within = request_.bound.holds_for(row);
}

}  // namespace

TuneOutcome tune(const TuneRequest& request) {
  check_bound(request.bound);
  return Tuning(request).run();
}

}  // namespace pellucid::compare
