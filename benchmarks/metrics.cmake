# SPDX-License-Identifier: GPL-3.0-or-later
add_executable(bench_metrics EXCLUDE_FROM_ALL metrics_bench.cpp)
target_link_libraries(bench_metrics PRIVATE pellucid_compare benchmark::benchmark)
