# SPDX-License-Identifier: GPL-3.0-or-later
# Exact compositing against VTK's dual depth peeling. It needs a display: xvfb-run serves.
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel RenderingCore RenderingOpenGL2)
add_executable(bench_peeling EXCLUDE_FROM_ALL peeling_bench.cpp)
target_link_libraries(bench_peeling PRIVATE pellucid_compare benchmark::benchmark ${VTK_LIBRARIES})
vtk_module_autoinit(TARGETS bench_peeling MODULES VTK::RenderingOpenGL2)
