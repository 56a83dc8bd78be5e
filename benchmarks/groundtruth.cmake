# Exact compositing against Embree's bare traversal.
add_executable(bench_groundtruth EXCLUDE_FROM_ALL groundtruth_bench.cpp)
target_link_libraries(bench_groundtruth PRIVATE pellucid_groundtruth benchmark::benchmark)
