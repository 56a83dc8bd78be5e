# SPDX-License-Identifier: GPL-3.0-or-later
# Isosurfaces: exact against marched, sampling against OpenVDB's accessor, memory against the grids.
add_executable(bench_isosurface EXCLUDE_FROM_ALL isosurface_bench.cpp)
target_link_libraries(bench_isosurface PRIVATE pellucid_compare pellucid_openvdb benchmark::benchmark)
