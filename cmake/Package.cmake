# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# What `cmake --install` copies, and the Debian package that CPack makes of it:
#   scripts/package.sh
include(GNUInstallDirs)

set(package ${PROJECT_SOURCE_DIR}/resources/package)
install(TARGETS goniotool RUNTIME)
install(FILES ${package}/goniotool.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES LICENSES/Apache-2.0.txt LICENSES/GPL-3.0-or-later.txt resources/ATTRIBUTIONS.md README.md CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs FILES_MATCHING PATTERN "*.md")
if(GONIO_BUILD_GUI)
  install(TARGETS gonio RUNTIME)
  install(FILES ${package}/gonio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${package}/gonio.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
  install(FILES ${package}/gonio.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Gonio authors <gonio@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Editor for measured materials (BRDFs)")
set(CPACK_PACKAGE_DESCRIPTION "Opens measured materials (MERL, RGL, UTIA and others), edits them by the sliders of fitted
models, by factor curves and by interpolation, and exports them to renderers. With goniotool, which does the same work
without a window.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Plugins that Qt loads at run time: no program links them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6sql6-sqlite, libqt6svg6, libgl1-mesa-dri")
# The widths of Helvetica, the font of figures.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-liberation")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-numpy, python3-matplotlib")
include(CPack)
