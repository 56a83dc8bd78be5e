# SPDX-License-Identifier: GPL-3.0-or-later
# Exact compositing against Embree's bare traversal.
add_executable(bench_groundtruth EXCLUDE_FROM_ALL groundtruth_bench.cpp)
target_link_libraries(bench_groundtruth PRIVATE pellucid_groundtruth benchmark::benchmark)
add_executable(bench_groundtruth_size EXCLUDE_FROM_ALL groundtruth_size_bench.cpp)
target_link_libraries(bench_groundtruth_size PRIVATE pellucid_groundtruth benchmark::benchmark)
