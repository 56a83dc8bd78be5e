// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/study/study.h"
#include "core/error.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare::testing {

/// What is wrong with a study of these methods and further keys, as StudyFolder::study() takes
/// them.
inline std::string study_error(const std::string& methods, const std::string& more) {
  const StudyFolder folder;
  try {
    load_study(folder.study(methods, more), fake_methods());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace pellucid::compare::testing
