# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler flags that every target of ours shares, as the interface library pellucid_options.
set(PELLUCID_SANITIZE "" CACHE STRING "Value of -fsanitize=, or empty")

add_library(pellucid_options INTERFACE)
target_include_directories(pellucid_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(pellucid_options INTERFACE -Wall -Wextra -Wpedantic -Wnon-virtual-dtor)
# To GCC files that are compiled together are headers of one: it would tell of local names that are another file's, and
# of types of anonymous namespaces in what it takes for a header.
target_compile_options(pellucid_options INTERFACE
  $<IF:$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${PELLUCID_UNITY}>>,-Wshadow=local;-Wno-subobject-linkage,-Wshadow>)
# No contraction and no fast-math: the exact paths count on IEEE double as written.
target_compile_options(pellucid_options INTERFACE -ffp-contract=off)
# A program starts as fast as its libraries are found: only those whose functions it calls.
target_link_options(pellucid_options INTERFACE -Wl,--as-needed)
# A study's rows name the build that made them.
target_link_options(pellucid_options INTERFACE -Wl,--build-id=sha1)
if(PELLUCID_SANITIZE)
  # GCC 12 sees uninitialized values in instrumented library code.
  target_compile_options(pellucid_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_compile_options(pellucid_options INTERFACE -fsanitize=${PELLUCID_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(pellucid_options INTERFACE -fsanitize=${PELLUCID_SANITIZE})
endif()
