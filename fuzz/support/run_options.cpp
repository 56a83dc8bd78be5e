// SPDX-License-Identifier: GPL-3.0-or-later
// What every target asks of the fuzzer and the sanitizers, wherever it is started from.

#include <tbb/global_control.h>

extern "C" {

/// Loops run on one thread: the same input takes the same way each time, which the fuzzer counts
/// on.
int LLVMFuzzerInitialize(int*, char***) {
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}

/// AddressSanitizer's options. Freed memory is held back up to 32 MiB: 256, its default, would fill
/// half of what scripts/fuzz grants a target. Vectors of libraries that gcc has built say nothing
/// of their capacity, so that overflows of containers would be found where there are none.
const char* __asan_default_options() {
  return "quarantine_size_mb=32:detect_container_overflow=0:allocator_may_return_null=0";
}

const char* __ubsan_default_options() { return "print_stacktrace=1"; }

/// VTK's geometry filter loses two bytes a call.
const char* __lsan_default_suppressions() { return "leak:vtkGeometryFilter::RequestData"; }
}
