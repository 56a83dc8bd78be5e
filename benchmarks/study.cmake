# SPDX-License-Identifier: GPL-3.0-or-later
add_executable(bench_study EXCLUDE_FROM_ALL study_bench.cpp)
target_link_libraries(bench_study PRIVATE pellucid_compare benchmark::benchmark)
