// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/interleave.h"

#include <memory>

#include "core/error.h"

namespace pellucid::compare {
namespace {

/// A Turn is a cell that is measured in turn with others.
struct Turn {
  std::unique_ptr<CellMeter> meter;  // none once the cell has failed
  std::string error;

  /// Runs `work` on the meter; any exception ends the cell.
  template <class Work>
  void attempt(const Work& work) {
    if (!error.empty()) return;
    try {
      work();
    } catch (const std::exception& failure) {
      error = one_line(failure.what());
      meter.reset();
    }
  }
  bool goes_on(const TimingRule& timing) const {
    return meter && !is_over(meter->seconds(), timing);
  }
};

/// Times each once that goes on, from the `first`-th around. Returns whether there was one.
bool run_round(std::vector<Turn>& turns, std::size_t first, const TimingRule& timing) {
  bool any = false;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Turn& turn = turns[(first + i) % turns.size()];
    if (!turn.goes_on(timing)) continue;
    turn.attempt([&] { turn.meter->time_once(); });
    any = true;
  }
  return any;
}

MeasuredCell finished(Turn& turn, const TimingRule& timing) {
  MeasuredCell cell;
  turn.attempt([&] { cell.measurement = turn.meter->finish(timing); });
  cell.error = turn.error;
  turn.meter.reset();
  return cell;
}

}  // namespace

std::vector<MeasuredCell> measure_interleaved(std::span<const Cell> cells,
                                              const scene::Scene& scene, const TimingRule& timing,
                                              std::span<const scene::RenderContext> contexts,
                                              const std::function<void()>& between) {
  std::vector<Turn> turns(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    turns[i].attempt([&] {
      turns[i].meter = std::make_unique<CellMeter>(cells[i], scene, contexts[i],
                                                   is_drawn_once(cells[i], timing));
    });
  for (std::size_t round = 0; run_round(turns, round, timing); ++round) between();
  std::vector<MeasuredCell> measured;
  for (Turn& turn : turns) measured.push_back(finished(turn, timing));
  return measured;
}

}  // namespace pellucid::compare
