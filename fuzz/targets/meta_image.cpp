// SPDX-License-Identifier: GPL-3.0-or-later
// The header with its data behind it (LOCAL), or in data.raw: 2 × 2 × 2 vectors of floats.

#include "fields/levels/level_files.h"
#include "fields/make_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "fuzz/support/use_field.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::FileInMemory file("input.mhd", {{"data.raw", std::string(96, '@')}});
  file.with({data, size});
  for (const char* options : {"", ":sampler=c1"})
    fuzz::attempt(file.name(),
                  [&] { fuzz::use(*fields::make_field(file.path().string() + options)); });
  fuzz::attempt(file.name(), [&] { fields::read_levels(file.path(), "MetaImage"); });
  return 0;
}
