// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/conform/conform.h"

namespace pellucid::compare {

/// A ListedRenderer draws the cases of the conformance suite, or has drawn them: by a call, which
/// may be an external command, or in a folder of pictures.
struct ListedRenderer {
  std::string name;
  std::optional<MethodCall> call = std::nullopt;
  std::filesystem::path pictures = {};
  std::string left_out = {};  // why it cannot be asked here; empty: it can
};

/// A RendererList is the question of a report: what do these draw?
struct RendererList {
  std::string title = "What does my tool draw?";
  std::vector<ListedRenderer> renderers;
};

/// Reads {"title": TEXT, "renderers": [ENTRY, …]}. An entry is a method of the program, as in a
/// study; {"external": NAME, "command": [WORD, …], …} as in a study, left out where its program is
/// not there; or {"pictures": FOLDER, "name": NAME}. Relative files start at the list's folder.
/// Throws InputError that names the place, also for a name that comes twice.
RendererList read_renderer_list(const std::filesystem::path& file);

/// A RendererResult is what became of the suite.
struct RendererResult {
  ListedRenderer renderer;
  std::vector<CaseResult> cases = {};  // none of one that is left out

  std::size_t passed() const;
  /// Returns how many pictures pass or, stored in 8 bits, are right to two steps of these.
  std::size_t right_to_two_steps() const;
  /// Returns why there is nothing to judge: it is left out, or drew none of the cases.
  std::string nothing_drawn() const;
};

/// Asks all renderers of the list, one after the other. Of `request` its call and its pictures are
/// each renderer's; on_case gets the share of all.
std::vector<RendererResult> conform_all(const RendererList& list, const ConformRequest& request);

}  // namespace pellucid::compare
