# SPDX-License-Identifier: GPL-3.0-or-later
# pellucid_unity(TARGET [FOLDER|FILE…]): compiles the .cpp files of a folder by eight, which parses their headers once
# instead of eight times. Names in anonymous namespaces are therefore one folder's, not one file's. The FILEs, those in
# the FOLDERs, and those with options or definitions of their own are compiled alone.
option(PELLUCID_UNITY "Compile the files of a folder by eight: less time for all of them, more for one that changed" OFF)

function(pellucid_unity target)
  if(NOT PELLUCID_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "^${CMAKE_BINARY_DIR}")
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(folder_name ${folder} NAME)
    get_filename_component(file_name ${source} NAME)
    if(folder_name IN_LIST ARGN OR file_name IN_LIST ARGN)
      continue()
    endif()
    string(MAKE_C_IDENTIFIER ${folder} group)
    math(EXPR count_${group} "${count_${group}} + 1")
    math(EXPR part "(${count_${group}} - 1) / 8")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()
