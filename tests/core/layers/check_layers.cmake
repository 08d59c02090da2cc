# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# cmake -DROOT=FOLDER -DROOMS=A,B,.. -P check_layers.cmake: fails where a layer includes from a layer above it, or a room
# of core from a room behind it in ROOMS. Lists every offence.
cmake_minimum_required(VERSION 3.22)

set(qt "[<\"](Q[A-Z][A-Za-z0-9]*|Qt[A-Z][A-Za-z0-9]*/.*)(\\.h)?[>\"]")
set(opengl "[<\"](GL|GLES[0-9]*|EGL|KHR|OpenGL|GLFW|epoxy|glad)/")

# layer_must_not_include(FOLDER WHAT REGEX)
function(layer_must_not_include folder what regex)
  file(GLOB_RECURSE files ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  foreach(file ${files})
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*${regex}")
    foreach(line ${lines})
      message(SEND_ERROR "${file} includes ${what}: ${line}")
    endforeach()
  endforeach()
  list(LENGTH files count)
  message(STATUS "${folder}: ${count} files looked at for ${what}")
endfunction()

layer_must_not_include(core Qt "${qt}")
layer_must_not_include(core OpenGL "${opengl}")
layer_must_not_include(core "the layers above it" "[<\"](widgets|app|tests)/")
layer_must_not_include(widgets "the layers above it" "[<\"](app|tests)/")

string(REPLACE "," ";" rooms "${ROOMS}")
while(rooms)
  list(POP_FRONT rooms room)
  if(rooms)
    list(JOIN rooms "|" above)
    layer_must_not_include(core/${room} "a room above it" "[<\"]core/(${above})/")
  endif()
endwhile()
