# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# cmake -DROOT=FOLDER -DCORE_ROOMS=A,B,.. -DWIDGET_ROOMS=.. -DAPP_ROOMS=.. -P check_layers.cmake: fails where a layer
# includes from a layer above it, or a room from a room behind it in its layer's list. Lists every offence.
cmake_minimum_required(VERSION 3.22)

set(qt "[<\"](Q[A-Z][A-Za-z0-9]*|Qt[A-Z][A-Za-z0-9]*/.*)(\\.h)?[>\"]")
set(opengl "[<\"](GL|GLES[0-9]*|EGL|KHR|OpenGL|GLFW|epoxy|glad)/")

# must_not_include(FOLDER WHAT REGEX [FILE ...]): the files may.
function(must_not_include folder what regex)
  file(GLOB_RECURSE files ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  list(REMOVE_ITEM files ${ARGN})
  foreach(file ${files})
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*${regex}")
    foreach(line ${lines})
      message(SEND_ERROR "${file} includes ${what}: ${line}")
    endforeach()
  endforeach()
  list(LENGTH files count)
  message(STATUS "${folder}: ${count} files checked for ${what}")
endfunction()

# check_rooms(LAYER ROOMS): a room may hold rooms of its own (preview and preview/gl), each a line of the list.
function(check_rooms layer rooms)
  string(REPLACE "," ";" rooms "${rooms}")
  while(rooms)
    list(POP_FRONT rooms room)
    if(rooms)
      list(JOIN rooms "|" above)
      must_not_include(${layer}/${room} "a room above it" "[<\"]${layer}/(${above})/[^/]*[>\"]")
    endif()
  endwhile()
endfunction()

must_not_include(core Qt "${qt}")
must_not_include(core OpenGL "${opengl}")
must_not_include(core "the layers above it" "[<\"](widgets|app|tests)/")
must_not_include(widgets "the layers above it" "[<\"](app|tests)/")
must_not_include(python "other layers than core" "[<\"](widgets|app|tests)/")
check_rooms(core "${CORE_ROOMS}")
check_rooms(widgets "${WIDGET_ROOMS}")
check_rooms(app/gonio "${APP_ROOMS}")
# Menus and panels get what they use: the window composes them, and none of them knows it.
must_not_include(app/gonio "the window" "\"app/gonio/window/main_window.h\"" ${ROOT}/app/gonio/main.cpp
                 ${ROOT}/app/gonio/window/main_window.cpp)
