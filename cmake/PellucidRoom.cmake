# SPDX-License-Identifier: GPL-3.0-or-later
# pellucid_room(NAME ORDER … ROOMS … LIBRARIES …): one static library per room from the room's .cpp
# files. ORDER are its sub-rooms, and the files at its top by their stems, in the order in which data
# passes: each includes only itself and those before it. ROOMS are the rooms to its left that it
# includes; LIBRARIES come from elsewhere. tests/rooms/check_rooms.py holds the includes to both.
function(pellucid_room name)
  cmake_parse_arguments(room "" "" "ORDER;ROOMS;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(pellucid_${name} STATIC ${sources})
  list(TRANSFORM room_ROOMS PREPEND pellucid_)
  target_link_libraries(pellucid_${name} PUBLIC pellucid_options ${room_ROOMS} ${room_LIBRARIES})
endfunction()
