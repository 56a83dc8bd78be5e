// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compare/run/scene_at_hand.h"
#include "compare/run/screening.h"
#include "compare/run/study_jobs.h"

namespace pellucid::compare {

/// A StudyScreen finds the cells of a study that are not drawn in full, by the study's ScreenRule,
/// and keeps what it found beside the cells: cells/SCENE/.screen.json. Both outlive it.
class StudyScreen {
 public:
  StudyScreen(const Study& study, const StudyOptions& options) : study_(study), options_(options) {}

  /// Returns the names of a scene's cells that are left out; none without a rule, where cells are
  /// named by `only`, and where the scene cannot be drawn, as its reference's row says. With
  /// `resume` they are those that the last run of this build left out.
  std::set<std::string> left_out(std::span<const Job> scene, SceneAtHand& at_hand,
                                 double progress) const;

  /// Returns the study with notes about what was left out, and writes screened.csv. Of the jobs
  /// each `per_scene` are a scene's.
  Study tell(std::span<const Job> jobs, std::size_t per_scene) const;

 private:
  std::vector<ScreenedCall> screen(std::span<const Job> scene, SceneAtHand& at_hand,
                                   double progress) const;
  std::filesystem::path file(std::span<const Job> scene) const;
  std::string key(std::span<const Job> scene) const;

  const Study& study_;
  const StudyOptions& options_;
};

}  // namespace pellucid::compare
