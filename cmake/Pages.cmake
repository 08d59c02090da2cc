# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# The pages of the documentation, complete, in <build folder>/docs: goniotool replaces comments such as
# <!-- options: fit --> by tables; the reference of the Python module, which no page of docs contains, is added.
# GONIO_PAGES lists the pages of the guide; gonio_pages is the target that makes them.
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
set(folder ${PROJECT_BINARY_DIR}/docs)
file(MAKE_DIRECTORY ${folder})
set(completed)

# Writes OUTPUT only if its text changes, so that what contains the page is not built again after each build of goniotool.
function(gonio_page output)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "COMMAND;DEPENDS")
  add_custom_command(OUTPUT ${output}
    COMMAND ${ARG_COMMAND} > ${output}.new
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${output}.new ${output}
    DEPENDS ${ARG_DEPENDS} VERBATIM)
endfunction()

# What a sanitizer finds, or a program for another processor, would stop the build: then the pages remain as in docs.
if(NOT GONIO_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
  foreach(page ${pages})
    cmake_path(GET page FILENAME name)
    gonio_page(${folder}/${name} COMMAND goniotool --complete-page ${page} DEPENDS goniotool ${page})
    list(APPEND completed ${folder}/${name})
  endforeach()
  set(pages)
endif()

# It reads the sources of the package alone: the module need not be built, nor NumPy installed.
find_package(Python3 3.9 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/gonio/*.py)
  set(script ${PROJECT_SOURCE_DIR}/scripts/python_reference.py)
  gonio_page(${folder}/python-reference.md COMMAND ${Python3_EXECUTABLE} -B ${script} DEPENDS ${script} ${sources})
  list(APPEND completed ${folder}/python-reference.md)
else()
  message(STATUS "Python 3.9 not found: the guide has no reference of the Python module")
endif()

add_custom_target(gonio_pages ALL DEPENDS ${completed})
set(GONIO_PAGES ${pages} ${completed})
