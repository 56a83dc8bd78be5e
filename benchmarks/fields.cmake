add_executable(fields_bench EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/fields_bench.cpp
                                             ${CMAKE_SOURCE_DIR}/tests/fields/grid_files.cpp)
target_link_libraries(fields_bench PRIVATE pellucid_fields pellucid_openvdb benchmark::benchmark)
