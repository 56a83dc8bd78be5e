# SPDX-License-Identifier: GPL-3.0-or-later
# pellucid_embed(TARGET NAMESPACE FILE…): makes each file's bytes available as
#   std::string_view NAMESPACE::name(), name = the file's name with . and - as _
# through the generated header "NAMESPACE.h" (in the target's binary folder), and all of them as
#   std::span<const NAMESPACE::File> NAMESPACE::files(), by their path from the project's root.
function(pellucid_embed target namespace)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(outputs "")
  foreach(file ${ARGN})
    get_filename_component(path ${file} ABSOLUTE)
    list(APPEND paths ${path})
  endforeach()
  add_custom_command(
    OUTPUT ${folder}/${namespace}.cpp ${folder}/${namespace}.h
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${folder}/${namespace} -DNAMESPACE=${namespace} -DROOT=${CMAKE_SOURCE_DIR} "-DFILES=${paths}"
            -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${paths} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    VERBATIM)
  # `embedded` makes them all, for tools that parse the sources and compile nothing.
  if(NOT TARGET embedded)
    add_custom_target(embedded)
  endif()
  add_custom_target(embedded_${namespace} DEPENDS ${folder}/${namespace}.h)
  add_dependencies(embedded embedded_${namespace})
  add_dependencies(${target} embedded_${namespace})
  target_sources(${target} PRIVATE ${folder}/${namespace}.cpp ${folder}/${namespace}.h)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
