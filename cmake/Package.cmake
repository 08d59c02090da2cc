# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# What `cmake --install` copies, and the Debian package that CPack makes of it:
#   scripts/package.sh
include(GNUInstallDirs)

set(package ${PROJECT_SOURCE_DIR}/resources/package)
set(CPACK_PACKAGE_CONTACT "The Gonio authors <gonio@gonio.invalid>")
# Packages are made of the targets that scripts/package.sh builds, not of all.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
install(TARGETS goniotool RUNTIME)
install(FILES LICENSES/Apache-2.0.txt LICENSES/GPL-3.0-or-later.txt resources/ATTRIBUTIONS.md README.md CHANGELOG.md
  ${package}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs FILES_MATCHING PATTERN "*.md")
install(FILES ${GONIO_BLENDER_ADDON} DESTINATION ${CMAKE_INSTALL_DATADIR}/gonio)

# install_compressed(FILE FOLDER NAME): the file as NAME.gz, without its time, as Debian wants manual pages and changelogs.
function(install_compressed file folder name)
  set(compressed ${CMAKE_CURRENT_BINARY_DIR}/package/${name}.gz)
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package)
  execute_process(COMMAND gzip -9n INPUT_FILE ${file} OUTPUT_FILE ${compressed} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${compressed} DESTINATION ${folder})
endfunction()
install_compressed(${package}/goniotool.1 ${CMAKE_INSTALL_MANDIR}/man1 goniotool.1)
configure_file(${package}/changelog.in ${CMAKE_CURRENT_BINARY_DIR}/package/changelog @ONLY)
install_compressed(${CMAKE_CURRENT_BINARY_DIR}/package/changelog ${CMAKE_INSTALL_DOCDIR} changelog)
if(GONIO_BUILD_GUI)
  install(TARGETS gonio RUNTIME)
  install(FILES ${package}/gonio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${package}/gonio.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
  install(FILES ${package}/gonio.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
  install(FILES ${package}/org.gonio.gonio.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install_compressed(${package}/gonio.1 ${CMAKE_INSTALL_MANDIR}/man1 gonio.1)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Editor for measured materials (BRDFs)")
set(CPACK_PACKAGE_DESCRIPTION "Opens measured materials (MERL, RGL, UTIA and others), edits them by the
sliders of fitted models, by factor curves and by interpolation, and exports
them to renderers. With goniotool, which does the same work without a window,
and the Python module gonio.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Plugins that Qt loads at run time: no program links them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6sql6-sqlite, libqt6svg6, libgl1-mesa-dri")
if(GONIO_PYTHON_VERSION)
  string(REGEX MATCH "[0-9]+$" minor ${GONIO_PYTHON_VERSION})
  math(EXPR next "${minor} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3 (>= ${GONIO_PYTHON_VERSION}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${package}/postinst ${package}/prerm)
endif()
# The widths of Helvetica, the font of figures; Qt's plugin for Wayland.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, fonts-liberation, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib, blender")
include(CPack)
