# SPDX-License-Identifier: GPL-3.0-or-later
# Each order-independent method against the bare passes that it cannot do without.
add_executable(bench_oit EXCLUDE_FROM_ALL oit_bench.cpp)
target_link_libraries(bench_oit PRIVATE pellucid_oit benchmark::benchmark)
