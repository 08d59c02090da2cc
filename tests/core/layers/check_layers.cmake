# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# cmake -DROOT=FOLDER -DCORE_MODULES=A,B,.. -DWIDGET_MODULES=.. -DAPP_MODULES=.. -P check_layers.cmake: fails where a layer
# includes from a layer above it, or a module from a module behind it in its layer's list, or where the namespace of a module of
# core has another name than its folder. Lists every offence.
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

# check_modules(LAYER MODULES): a module may hold modules of its own (preview and preview/gl), each a line of the list. Other
# folders in it (export/shaders) are parts of it.
function(check_modules layer modules)
  string(REPLACE "," ";" modules "${modules}")
  set(files)
  foreach(module ${modules})
    if(";${modules}" MATCHES ";${module}/")
      list(APPEND files "${module}/[^/]*")
    else()
      list(APPEND files "${module}/.*")
    endif()
  endforeach()
  while(modules)
    list(POP_FRONT modules module)
    list(POP_FRONT files)
    if(modules)
      list(JOIN files "|" above)
      must_not_include(${layer}/${module} "a module above it" "[<\"]${layer}/(${above})[>\"]")
    endif()
  endwhile()
endfunction()

# check_namespaces(MODULES): a module of core has its own namespace; the modules at the bottom share gonio, `export` is a keyword.
function(check_namespaces modules)
  string(REPLACE "," ";" modules "${modules}")
  foreach(module ${modules})
    set(name "gonio::${module}")
    if(module MATCHES "^(support|math|coordinates|brdf|sampling)$")
      set(name gonio)
    elseif(module STREQUAL export)
      set(name gonio::exports)
    endif()
    file(GLOB_RECURSE files ${ROOT}/core/${module}/*.h ${ROOT}/core/${module}/*.cpp)
    foreach(file ${files})
      file(STRINGS ${file} lines REGEX "^namespace gonio[a-z_:]* {$")
      foreach(line ${lines})
        if(NOT line MATCHES "^namespace ${name}(::[a-z_]+)? {$")
          message(SEND_ERROR "${file} should be in the namespace ${name}: ${line}")
        endif()
      endforeach()
    endforeach()
  endforeach()
endfunction()

must_not_include(core Qt "${qt}")
must_not_include(core OpenGL "${opengl}")
must_not_include(core "the layers above it" "[<\"](widgets|app|tests)/")
must_not_include(widgets "the layers above it" "[<\"](app|tests)/")
must_not_include(python "other layers than core" "[<\"](widgets|app|tests)/")
check_modules(core "${CORE_MODULES}")
check_namespaces("${CORE_MODULES}")
check_modules(widgets "${WIDGET_MODULES}")
check_modules(app/gonio "${APP_MODULES}")
# Menus and panels get what they use: the window composes them, and none of them knows it.
must_not_include(app/gonio "the window" "\"app/gonio/window/main_window.h\"" ${ROOT}/app/gonio/main.cpp
                 ${ROOT}/app/gonio/development.cpp ${ROOT}/app/gonio/window/main_window.cpp)
