# Each order-independent method against the bare passes that it cannot do without.
add_executable(oit_bench ${CMAKE_SOURCE_DIR}/benchmarks/oit_bench.cpp)
set_target_properties(oit_bench PROPERTIES EXCLUDE_FROM_ALL TRUE)
target_link_libraries(oit_bench PRIVATE pellucid_oit benchmark::benchmark)
