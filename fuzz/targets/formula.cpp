// SPDX-License-Identifier: GPL-3.0-or-later
// "u=…,v=…,w=…" over x, y, z, t.

#include "fields/make_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/bytes.h"
#include "fuzz/support/use_field.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = "formula:" + std::string(fuzz::text_of({data, size}));
  fuzz::attempt("", [&] { fuzz::use(*fields::make_field(text)); });
  return 0;
}
