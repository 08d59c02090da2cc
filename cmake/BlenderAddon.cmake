# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# GONIO_BLENDER_ADDON: the add-on as the file that Blender installs, of resources/blender/gonio. The same sources give the same
# bytes.
set(GONIO_BLENDER_ADDON ${PROJECT_BINARY_DIR}/gonio_blender.zip)
set(blender ${PROJECT_SOURCE_DIR}/resources/blender)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${blender}/gonio/__init__.py)
execute_process(COMMAND ${CMAKE_COMMAND} -E env TZ=UTC ${CMAKE_COMMAND} -E tar cf ${GONIO_BLENDER_ADDON} --format=zip --mtime=2026-11-30
  gonio/__init__.py WORKING_DIRECTORY ${blender} COMMAND_ERROR_IS_FATAL ANY)
