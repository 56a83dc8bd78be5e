// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/study_screen.h"

#include <fmt/format.h>

#include <exception>

#include "compare/run/screened_calls.h"
#include "core/files/output_file.h"

namespace pellucid::compare {

std::set<std::string> StudyScreen::left_out(std::span<const Job> scene, SceneAtHand& at_hand,
                                            double progress) const {
  if (!study_.screen || !options_.only.empty()) return {};
  auto calls = options_.resume ? read_screen(file(scene), key(scene)) : std::nullopt;
  if (!calls) calls = screen(scene, at_hand, progress);
  std::set<std::string> names;
  for (const ScreenedCall& out : *calls)
    names.insert(scene.front().cell.scene + '/' + out.own.call);
  return names;
}

std::vector<ScreenedCall> StudyScreen::screen(std::span<const Job> scene, SceneAtHand& at_hand,
                                              double progress) const {
  const auto tell = [&](const std::string& what) {
    report(options_.progress, progress, scene.front().cell.scene + '/' + what);
  };
  try {
    auto calls = screen_calls(study_.methods, study_.reference, at_hand.scene(), *study_.screen,
                              options_.context, tell);
    write_screen(file(scene), key(scene), calls);
    return calls;
  } catch (const std::exception&) {  // its rows say what is wrong with the scene or its reference
    return {};
  }
}

Study StudyScreen::tell(std::span<const Job> jobs, std::size_t per_scene) const {
  Study told = study_;
  if (!study_.screen) return told;
  std::vector<std::pair<std::string, std::size_t>> scenes;
  std::string csv = "scene,size,call,seconds,rmse,bytes,by,by_seconds,by_rmse,by_bytes\n";
  for (std::size_t first = 0; first < jobs.size(); first += per_scene) {
    const auto scene = jobs.subspan(first, per_scene);
    const auto calls = read_screen(file(scene), key(scene));
    if (!calls || calls->empty()) continue;
    scenes.emplace_back(scene.front().cell.scene, calls->size());
    csv += csv_screen(scene.front().cell.scene, *calls);
  }
  if (!scenes.empty()) told.notes.push_back(screen_note(scenes));
  write_text(options_.folder / "screened.csv", csv);
  return told;
}

std::filesystem::path StudyScreen::file(std::span<const Job> scene) const {
  return scene.front().files.row().parent_path() / ".screen.json";
}

std::string StudyScreen::key(std::span<const Job> scene) const {
  std::string key = options_.build;
  for (const double size : study_.screen->sizes) key += fmt::format(" {}", size);
  key += fmt::format(" {}", study_.screen->margin);
  for (const Job& job : scene) key += ' ' + job.fingerprint;
  return key;
}

}  // namespace pellucid::compare
