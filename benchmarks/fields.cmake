# SPDX-License-Identifier: GPL-3.0-or-later
add_executable(bench_fields EXCLUDE_FROM_ALL fields_bench.cpp
                                             ${CMAKE_SOURCE_DIR}/tests/fields/readers/grid_files.cpp)
target_link_libraries(bench_fields PRIVATE pellucid_fields pellucid_openvdb benchmark::benchmark)
