# SPDX-License-Identifier: GPL-3.0-or-later
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore FiltersFlowPaths IOXML)
add_executable(bench_integrators EXCLUDE_FROM_ALL integrators_bench.cpp)
target_link_libraries(bench_integrators PRIVATE pellucid_integrators benchmark::benchmark ${VTK_LIBRARIES})
# The same surfaces by Pellucid and by VTK's vtkStreamSurface, side by side in one run.
add_executable(bench_integrators_vtk EXCLUDE_FROM_ALL integrators_vtk_bench.cpp)
target_link_libraries(bench_integrators_vtk PRIVATE pellucid_integrators benchmark::benchmark ${VTK_LIBRARIES})
# The numbers of docs/integrators.md that are no times.
add_executable(bench_integrators_accuracy EXCLUDE_FROM_ALL integrators_accuracy.cpp)
target_link_libraries(bench_integrators_accuracy PRIVATE pellucid_integrators benchmark::benchmark)
