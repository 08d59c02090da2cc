# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# gonio_options: the flags that every target of the project shares.
add_library(gonio_options INTERFACE)
target_compile_features(gonio_options INTERFACE cxx_std_20)
target_compile_options(gonio_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:GONIO_UNCHECKED_CONVERSIONS>>>:-Wconversion> -Wno-sign-conversion
  # Designated initializers leave fields at their defaults on purpose.
  -Wno-missing-field-initializers
  # The same expression must give the same bits wherever it is inlined: an unchanged edit is the identity.
  -ffp-contract=off
  # Square roots and selections become vector code only where no error flags are kept; the values are the same.
  -fno-math-errno -fno-trapping-math)
# GCC 12 warns of its own headers: of vector code where Eigen is inlined (GCC bug 105593), of strings (105329, 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(gonio_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Of a std::optional in another one (GCC bug 80635); of vectors with one element; of references to
  # records that a function finds by a temporary name (GCC 14 cannot tell them from references into the name).
  target_compile_options(gonio_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-dangling-reference)
endif()
# GCC spends a tenth of a compilation on collecting its garbage; with this much memory it seldom does.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gonio_options INTERFACE --param=ggc-min-heapsize=1000000)
endif()
if(GONIO_WARNINGS_AS_ERRORS)
  target_compile_options(gonio_options INTERFACE -Werror)
endif()
if(GONIO_MODERN_PROCESSOR)
  # One level for all machines rather than -march=native: the same numbers everywhere, and programs that can be copied.
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3")
  check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"x86-64-v3\") ? 0 : 1; }" GONIO_HAS_X86_64_V3)
  unset(CMAKE_REQUIRED_FLAGS)
  if(GONIO_HAS_X86_64_V3)
    target_compile_options(gonio_options INTERFACE -march=x86-64-v3)
  endif()
endif()
if(GONIO_SANITIZE)
  target_compile_options(gonio_options INTERFACE -fsanitize=${GONIO_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(gonio_options INTERFACE -fsanitize=${GONIO_SANITIZE})
  # GCC and clang name it differently.
  if(GONIO_SANITIZE MATCHES "thread")
    target_compile_definitions(gonio_options INTERFACE GONIO_THREAD_SANITIZER)
  endif()
endif()

# gonio_unity(TARGET): compiles up to GONIO_UNITY_FILES sources of a target at once. Names in the anonymous namespaces of a
# target therefore differ from file to file.
function(gonio_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${GONIO_UNITY} UNITY_BUILD_BATCH_SIZE ${GONIO_UNITY_FILES})
endfunction()
