# The same surfaces by Pellucid and by VTK's vtkStreamSurface, side by side in one run.
find_package(VTK REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore FiltersFlowPaths IOXML)
add_executable(bench_integrators EXCLUDE_FROM_ALL integrators_bench.cpp)
target_link_libraries(bench_integrators PRIVATE pellucid_integrators benchmark::benchmark ${VTK_LIBRARIES})
