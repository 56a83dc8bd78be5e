# SPDX-License-Identifier: GPL-3.0-or-later
# pellucid_room(NAME ORDER … ROOMS … LIBRARIES …): one static library per room from the room's .cpp
# files. ORDER are its sub-rooms, and the files at its top by their stems, in the order in which data
# passes: each includes only itself and those before it. ROOMS are the rooms to its left that it
# includes; LIBRARIES come from elsewhere; APART are files for only one program, which adds them;
# ALONE are sub-rooms whose files have functions of the same names, one a row of a table, and files: they are compiled
# one by one.
# tests/rooms/check_rooms.py holds the includes to ORDER and ROOMS.
function(pellucid_room name)
  cmake_parse_arguments(room "" "" "ORDER;ROOMS;LIBRARIES;APART;ALONE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM room_APART PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  if(room_APART)
    list(REMOVE_ITEM sources ${room_APART})
  endif()
  add_library(pellucid_${name} STATIC ${sources})
  pellucid_unity(pellucid_${name} ${room_ALONE})
  list(TRANSFORM room_ROOMS PREPEND pellucid_)
  target_link_libraries(pellucid_${name} PUBLIC pellucid_options ${room_ROOMS} ${room_LIBRARIES})
endfunction()
