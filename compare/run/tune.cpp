// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <tuple>

#include "compare/cells/measure_cell.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/given_faults.h"
#include "compare/run/contest.h"
#include "compare/run/entrants.h"
#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

constexpr int small_by = 4;             // a small picture has so many times fewer pixels on a side
constexpr double contender_within = 2;  // the least of a few times is known to such a factor,
constexpr double hopeless = 8;          // and one of two to such a one: what disturbs a machine
constexpr int fair_times = 5;  // for a while, disturbs both of two that take turns so often
constexpr std::size_t quick_times = 9;  // of a picture until so many seconds are spent on it:
constexpr double quick_seconds = 0.1;   // what delays a process for some ms hits not all of them
constexpr std::size_t most_contenders = 12;  // they have their memory at once
constexpr double narrow = 0.01;
constexpr double small_part = 0.3;    // of the time for small pictures, and until
constexpr double drawing_part = 0.7;  // for whole ones; the rest is for the contenders
constexpr int fewest_times = 5;
/// The others take longer than many a picture.
const std::string judged_by[]{"rmse", "ssim", "psnr", "max_error", "rmse_covered", "ssim_covered"};

/// An error that is not known is no small one.
double rmse_of(const ResultRow& row) {
  return row.metrics.linear.of("rmse").value_or(std::numeric_limits<double>::infinity());
}

/// Whose row comes first in the table: by the cost that was asked for, of equal bytes by the error.
bool is_cheaper(Cost cost, const ResultRow& a, const ResultRow& b) {
  if (a.error.empty() != b.error.empty()) return a.error.empty();
  if (cost == Cost::seconds) return a.seconds.median < b.seconds.median;
  const auto bytes_and_error = [](const ResultRow& row) {
    return std::pair(known_bytes(row), rmse_of(row));
  };
  return bytes_and_error(a) < bytes_and_error(b);
}

/// An Entrant is a candidate that competes.
struct Entrant {
  MethodCall call;
  std::size_t place;                         // among the candidates
  std::optional<double> small_seconds = {};  // of the small picture; none where time was over
  double small_setup = 0;
  std::unique_ptr<CellMeter> meter = nullptr;  // while it may be timed further
  ResultRow row = {};                          // once the whole picture was drawn
  bool drawn = false, within = false, tied = false;
  bool of_reference = false;  // its row is the reference's, which was drawn before

  /// The least time is nearest to what nothing disturbed.
  double least_seconds() const { return std::ranges::min(meter->seconds()); }
};

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
    time_contenders();
    report(request_.progress, 1, "tuned");
    return collect();
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

  bool is_slower(CellMeter& one, CellMeter& than, double factor) const;
  bool is_too_slow(Entrant& entrant);
  void choose_entrants();
  void draw_reference();
  void draw_small();
  TuneEstimate estimate() const;
  void enter(std::size_t index);
  void take_reference(Entrant& entrant);
  void draw(Entrant& entrant);
  void judge(const Image& image, Entrant& entrant);
  void keep_contenders();
  void finish(Entrant& entrant, const TimingRule& rule);
  void weigh();
  void time_contenders();
  TuneOutcome collect();

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

/// By times that are taken in turn: the least of either.
bool Tuning::is_slower(CellMeter& one, CellMeter& than, double factor) const {
  double of_one = std::numeric_limits<double>::infinity(), of_other = of_one;
  for (int k = 0; k < fair_times && !is_over(); ++k)
    for (auto& [meter, least] : {std::pair(&one, &of_one), std::pair(&than, &of_other)}) {
      meter->time_once();
      *least = std::min(*least, meter->seconds().back());
    }
  return of_one > factor * of_other;
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
      if (!is_slower(meter, *best->meter, 1)) return false;
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
  keep_contenders();
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
  judge(entrant.meter->image(), entrant);
  if (!entrant.within || request_.cost == Cost::bytes) return finish(entrant, fixed_repeats(1));
  // A second one at least, since chance may have delayed the first.
  for (double spent = 0;
       spent < quick_seconds && entrant.meter->seconds().size() < quick_times && !is_over();) {
    entrant.meter->time_once();
    spent += entrant.meter->seconds().back();
  }
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

/// Ends those that are too slow to be the fastest.
void Tuning::keep_contenders() {
  std::vector<Entrant*> in;
  for (Entrant& entrant : entrants_)
    if (entrant.meter) in.push_back(&entrant);
  std::ranges::stable_sort(in, {}, [](const Entrant* e) { return e->least_seconds(); });
  for (std::size_t i = 1; i < in.size(); ++i) {
    const double times = in[i]->least_seconds() / in.front()->least_seconds();
    const bool is_out = i >= most_contenders || times > hopeless ||
                        (times > contender_within &&
                         is_slower(*in[i]->meter, *in.front()->meter, contender_within));
    if (is_out) finish(*in[i], fixed_repeats(2));
  }
}

/// Takes the row, with the errors that are known, and frees what the method holds.
void Tuning::finish(Entrant& entrant, const TimingRule& rule) {
  CellMeasurement measured = entrant.meter->finish(rule);
  measured.row.metrics = entrant.row.metrics;
  measured.row.given_faults = std::move(entrant.row.given_faults);
  entrant.row = std::move(measured.row);
  entrant.meter.reset();
}

/// Bytes are the same in every run: those of the fewest are tied, whatever time they take.
void Tuning::weigh() {
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  for (const Entrant& entrant : entrants_)
    if (entrant.within) fewest = std::min(fewest, known_bytes(entrant.row));
  for (Entrant& entrant : entrants_)
    entrant.tied = entrant.within && known_bytes(entrant.row) == fewest;
}

void Tuning::time_contenders() {
  if (request_.cost == Cost::bytes) return weigh();
  std::vector<Entrant*> contenders;
  for (Entrant& entrant : entrants_)
    if (entrant.meter) contenders.push_back(&entrant);
  const TimingRule rule{std::min(fewest_times, request_.repeats), request_.repeats, narrow};
  const auto time_once = [&](std::size_t i) {
    tell(contenders[i]->call.text());
    contenders[i]->meter->time_once();
    return contenders[i]->meter->seconds();
  };
  const std::vector<bool> in =
      fastest_of(contenders.size(), rule, time_once, [&] { return !is_over(); });
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    best = std::min(best, contenders[i]->least_seconds());
    contenders[i]->tied = in[i];
    finish(*contenders[i], rule);
  }
  // Of one time alone, which tells no more than that.
  for (Entrant& entrant : entrants_)
    if (entrant.of_reference && entrant.within)
      entrant.tied = entrant.row.seconds.median <= contender_within * best;
}

TuneOutcome Tuning::collect() {
  std::erase_if(entrants_, [](const Entrant& entrant) { return !entrant.drawn; });
  std::ranges::stable_sort(entrants_, {}, &Entrant::place);
  std::ranges::stable_sort(entrants_, [&](const Entrant& a, const Entrant& b) {
    return is_cheaper(request_.cost, a.row, b.row);
  });
  const auto steady = [](const Entrant& e) {
    return std::tuple(known_bytes(e.row), rmse_of(e.row), e.place);
  };
  const Entrant* cheapest = nullptr;
  for (const Entrant& entrant : entrants_)
    if (entrant.tied && (!cheapest || steady(entrant) < steady(*cheapest))) cheapest = &entrant;
  for (Entrant& entrant : entrants_) {
    if (&entrant == cheapest) outcome_.cheapest = outcome_.rows.size();
    outcome_.within_bound.push_back(entrant.within);
    outcome_.tied.push_back(entrant.tied && &entrant != cheapest);
    outcome_.rows.push_back(std::move(entrant.row));
  }
  return std::move(outcome_);
}

}  // namespace

TuneOutcome tune(const TuneRequest& request) {
  check_bound(request.bound);
  return Tuning(request).run();
}

}  // namespace pellucid::compare
