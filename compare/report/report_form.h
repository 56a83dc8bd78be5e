// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace pellucid::compare {

/// A ReportForm says as what a study's report is written.
struct ReportForm {
  enum class Kind { automatic, file, folder };
  Kind kind = Kind::automatic;
  std::size_t most_bytes = 60'000'000;  // of one file
  std::string command = {};             // that the report was made by, for its provenance
};

}  // namespace pellucid::compare
