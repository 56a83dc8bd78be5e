# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install BUILD --prefix PREFIX, and the Debian package. Everything finds its files relative to itself
# (core/files/own_files.cpp), so that what is installed may be moved.
include(GNUInstallDirs)

# pellucid_install_data(OPTION…): what the program and the module need beside them.
function(pellucid_install_data)
  install(TARGETS ${PELLUCID_HELPERS} RUNTIME DESTINATION libexec/pellucid ${ARGN})
  install(DIRECTORY studies scenes DESTINATION share/pellucid ${ARGN})
endfunction()

install(TARGETS pellucid RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
pellucid_install_data(COMPONENT program)
install(DIRECTORY workflow adapters DESTINATION share/pellucid COMPONENT program USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE)
install(FILES README.md CHANGELOG.md LICENSE THIRD-PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Python's module, below the prefix as Debian has it; PYTHONPATH names it elsewhere.
if(TARGET pellucid_python)
  set(PELLUCID_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where Python's module goes, below the prefix")
  install(TARGETS pellucid_python LIBRARY DESTINATION ${PELLUCID_PYTHON_DIR}/pellucid COMPONENT python)
  install(FILES python/pellucid/__init__.py python/pellucid/__init__.pyi python/pellucid/py.typed
          DESTINATION ${PELLUCID_PYTHON_DIR}/pellucid COMPONENT python)
  # A wheel holds all that the module needs: setup.py asks for it, with the package's folder as prefix.
  install(TARGETS pellucid_python LIBRARY DESTINATION . COMPONENT wheel EXCLUDE_FROM_ALL)
  pellucid_install_data(COMPONENT wheel EXCLUDE_FROM_ALL)
endif()

# Manual pages and completions are printed by the program itself, from what --help reads.
set(pages ${CMAKE_BINARY_DIR}/pages)
set(printed ${pages}/pellucid.1 ${pages}/pellucid.bash ${pages}/_pellucid)
add_custom_command(OUTPUT ${printed}
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:pellucid> -DFOLDER=${pages} -P ${CMAKE_SOURCE_DIR}/cmake/print-pages.cmake
  DEPENDS pellucid cmake/print-pages.cmake VERBATIM)
add_custom_target(pellucid_pages ALL DEPENDS ${printed})
install(DIRECTORY ${pages}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program FILES_MATCHING PATTERN "*.1")
install(FILES ${pages}/pellucid.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME pellucid COMPONENT program)
install(FILES ${pages}/_pellucid DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)

# The library, for find_package(pellucid).
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pellucid)
install(TARGETS pellucid_library EXPORT pellucid LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(DIRECTORY library/include/pellucid ${CMAKE_BINARY_DIR}/library/include/pellucid
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library FILES_MATCHING PATTERN "*.h")
install(EXPORT pellucid NAMESPACE pellucid:: FILE pellucidConfig.cmake DESTINATION ${config_dir} COMPONENT library)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/pellucidConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/pellucidConfigVersion.cmake DESTINATION ${config_dir} COMPONENT library)

# One Debian package of all of it. Shared libraries that are loaded by name are not found by shlibdeps.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "The Pellucid authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
find_path(OSMESA_INCLUDE_DIR GL/osmesa.h)
if(OSMESA_INCLUDE_DIR)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6")
else()  # Mesa from 25.1 on
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libegl-mesa0")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, python3-numpy, fonts-liberation")
set(CPACK_STRIP_FILES ON)
include(CPack)
