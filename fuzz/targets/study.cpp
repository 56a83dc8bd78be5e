// SPDX-License-Identifier: GPL-3.0-or-later
// The study file, with a scene beside it.

#include "compare/study/study.h"
#include "compare/methods/methods.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::FileInMemory file(
      "input.json", {{"a.json", R"({"format": "pellucid-scene"})"}, {"b.json", "{}"}});
  fuzz::attempt(file.name(), [&] {
    const compare::Study study =
        compare::load_study(file.with({data, size}), compare::callable_methods());
    for (const compare::MethodCall& call : study.methods) call.slug();
  });
  return 0;
}
