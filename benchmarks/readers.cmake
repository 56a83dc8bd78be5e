# SPDX-License-Identifier: GPL-3.0-or-later
# What it costs to read a file in a process of its own, beside the same library in this one.
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel FiltersSources ImagingCore IOXML)
add_executable(bench_readers EXCLUDE_FROM_ALL readers_bench.cpp)
target_link_libraries(bench_readers PRIVATE pellucid_readers benchmark::benchmark ${VTK_LIBRARIES})
add_dependencies(bench_readers ${PELLUCID_HELPERS})
