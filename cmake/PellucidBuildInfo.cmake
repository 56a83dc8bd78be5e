# SPDX-License-Identifier: GPL-3.0-or-later
# The commit that a build was configured from, for provenance.
execute_process(COMMAND git describe --always --dirty --abbrev=12
                WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE PELLUCID_COMMIT
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT PELLUCID_COMMIT)
  set(PELLUCID_COMMIT "unknown")
endif()
