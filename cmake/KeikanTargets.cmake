# SPDX-License-Identifier: Apache-2.0
# What every target of the project shares.
#
#   keikan_flags     what users of the libraries must share: C++20, no contraction of a*b+c
#   keikan_warnings  what only our own code is held to: warnings are errors
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")  # checks (KEIKAN_CHECK) stay in every build; no -DNDEBUG games
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(keikan_flags INTERFACE)
add_library(keikan::flags ALIAS keikan_flags)
set_target_properties(keikan_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(keikan_flags INTERFACE cxx_std_20)
target_compile_options(keikan_flags INTERFACE -ffp-contract=off)
install(TARGETS keikan_flags EXPORT keikan-targets)

# Linked by our own targets alone and never installed. Headers of other projects are system headers, so
# they are not held to it.
add_library(keikan_warnings INTERFACE)
target_compile_options(keikan_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion -Wno-error=deprecated-declarations)

# Instructions of a certain processor, e.g. native or x86-64-v3. The results stay the same, bit for bit:
# contraction is off, and what remains (+ - * / sqrt) is rounded correctly at every vector width.
set(KEIKAN_MARCH "" CACHE STRING "Value for -march; empty: what the compiler does by itself")
if(KEIKAN_MARCH)
  add_compile_options(-march=${KEIKAN_MARCH})
endif()

# KEIKAN_DCHECK is alive in debug builds and under a sanitizer.
add_compile_definitions($<$<CONFIG:Debug>:KEIKAN_DEBUG_CHECKS>)
set(KEIKAN_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")
if(KEIKAN_SANITIZE)
  add_compile_options(-fsanitize=${KEIKAN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${KEIKAN_SANITIZE})
  add_compile_definitions($<$<NOT:$<CONFIG:Debug>>:KEIKAN_DEBUG_CHECKS>)
endif()

# For targets whose own code is hardly ever what takes the time, and whose headers (Catch2, CLI11) cost the
# compiler most of its time at -O3: less than half of the seconds, the same results.
function(keikan_optimise_lightly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Several sources as one translation unit, for targets whose headers cost more than their code: a third of the
# compiler's time. Files named after the target stay by themselves (names in them clash with others'). -DKEIKAN_UNITY=OFF compiles every file by itself.
option(KEIKAN_UNITY "Compile sources whose headers cost most several at a time" ON)
function(keikan_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KEIKAN_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  if(ARGN)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# keikan_library(clip SOURCES a.cpp ... PUBLIC keikan::model ... PRIVATE fmt::fmt ...)
# makes target keikan_clip, linked as keikan::clip. A library without sources is header-only.
function(keikan_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target keikan_${name})
  if(arg_SOURCES)
    add_library(${target} STATIC ${arg_SOURCES})
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} PUBLIC keikan_flags ${arg_PUBLIC} PRIVATE $<BUILD_INTERFACE:keikan_warnings> ${arg_PRIVATE})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} INTERFACE keikan_flags ${arg_PUBLIC})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(keikan::${name} ALIAS ${target})
  install(TARGETS ${target} EXPORT keikan-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # For the installed package: a component of this name, and what it stands on.
  set_property(GLOBAL APPEND PROPERTY KEIKAN_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY KEIKAN_LINKS_${name} ${arg_PUBLIC} ${arg_PRIVATE})
endfunction()

# keikan_tests(clip SOURCES a_test.cpp ... LINK keikan::clip ...) makes the Catch2 program
# keikan_clip_tests and one CTest entry for it. keikan_test_main holds Catch2's main, compiled once.
# Its files are compiled together, so they do not use one name for different things.
function(keikan_tests name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  set(target keikan_${name}_tests)
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE keikan_test_main keikan_warnings ${arg_LINK})
  target_compile_definitions(${target} PRIVATE KEIKAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  keikan_optimise_lightly(${target})
  keikan_compile_together(${target})
  add_test(NAME ${name} COMMAND ${target})
endfunction()
