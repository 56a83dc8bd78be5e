// SPDX-License-Identifier: GPL-3.0-or-later
// A series of a.mha and b.mha, which lie beside it, in any order and number.

#include "fields/make_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "fuzz/support/use_field.h"

using namespace pellucid;

namespace {

/// 2 × 2 × 2 vectors, each component of each the same float.
std::string frame(char byte) {
  return "NDims = 3\nDimSize = 2 2 2\nElementNumberOfChannels = 3\nElementType = MET_FLOAT\n"
         "ElementDataFile = LOCAL\n" +
         std::string(96, byte);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::FileInMemory file("input.series",
                                       {{"a.mha", frame('>')}, {"b.mha", frame('@')}});
  file.with({data, size});
  fuzz::attempt(file.name(), [] { fuzz::use(*fields::make_field(file.path().string())); });
  return 0;
}
