# Flags of every target. The bytes of a picture depend on the first line: no fused multiply-add
# beyond what the source says, and never -ffast-math (docs/develop/decisions.md).
add_library(sunfleck_flags INTERFACE)
target_compile_options(sunfleck_flags INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
target_compile_options(sunfleck_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# GCC 12 warns of string and vector copies that are right (GCC bug 105329), and its vectoriser of
# straight-line code drops the rounding of a pair of doubles to float and back (docs/develop/decisions.md).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(sunfleck_flags INTERFACE -Wno-restrict -Wno-stringop-overread
    -fno-tree-slp-vectorize)
endif()
if(SUNFLECK_WERROR)
  target_compile_options(sunfleck_flags INTERFACE -Werror)
endif()
# The oldest x86 that we run on (SSE4.2, 2009); Embree picks AVX2 by itself at run time.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  target_compile_options(sunfleck_flags INTERFACE -march=x86-64-v2)
endif()
target_include_directories(sunfleck_flags INTERFACE ${PROJECT_SOURCE_DIR}/src
  ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
# All objects can stand in the shared library, which exports what SUNFLECK_API marks and no more.
target_compile_options(sunfleck_flags INTERFACE -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)
target_compile_definitions(sunfleck_flags INTERFACE SUNFLECK_VERSION="${PROJECT_VERSION}")

# Where ccache is installed, it is used.
find_program(SUNFLECK_CCACHE ccache)
if(SUNFLECK_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${SUNFLECK_CCACHE})
endif()
# Headers are read once a module or once a program (cmake/modules.cmake, tests/CMakeLists.txt), and files
# compiled together, but not with ccache, which knows files one by one: such a build shows whether
# each includes what it uses.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
  set(SUNFLECK_TOGETHER OFF)
endif()

# Six files of the target at a time, which then read headers and make templates once. Local names must
# differ within the six; ALONE takes the files, with their folders, that are no part of it. Not where
# SUNFLECK_TOGETHER is off, for who edits.
function(sunfleck_compile_together target)
  cmake_parse_arguments(TOGETHER "" "" "ALONE" ${ARGN})
  foreach(file ${TOGETHER_ALONE})
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "${file}: is to be compiled alone and is not there")
    endif()
  endforeach()
  if(SUNFLECK_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
    set_source_files_properties(${TOGETHER_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()
