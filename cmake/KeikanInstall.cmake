# SPDX-License-Identifier: Apache-2.0
# The installed package: find_package(keikan COMPONENTS clip scene) from outside (see tests/consumer).
# Every library is a component. A component asks for the packages that it stands on and for no others, so
# that who wants the clipper alone needs no image or mesh library.
include(CMakePackageConfigHelpers)

# target of another project -> its package, as find_dependency wants it
set(package_TBB::tbb TBB)
set(package_fmt::fmt fmt)
set(package_fmt::fmt-header-only fmt)
set(package_glm::glm glm)
set(package_nlohmann_json::nlohmann_json nlohmann_json)
set(package_OpenEXR::OpenEXR OpenEXR)
set(package_Imath::Imath Imath)
set(package_PNG::PNG PNG)
set(package_ZLIB::ZLIB ZLIB)
set(package_assimp::assimp assimp)
set(package_Threads::Threads Threads)
set(package_embree embree)

get_property(components GLOBAL PROPERTY KEIKAN_COMPONENTS)
set(keikan_requirements "")
foreach(component IN LISTS components)
  get_property(links GLOBAL PROPERTY KEIKAN_LINKS_${component})
  set(needs "")
  set(packages "")
  foreach(link IN LISTS links)
    if(link MATCHES "^keikan::(.+)$")
      list(APPEND needs ${CMAKE_MATCH_1})
    elseif(DEFINED package_${link})
      list(APPEND packages ${package_${link}})
    elseif(link MATCHES "::")
      message(FATAL_ERROR "keikan::${component} links ${link}: name its package in cmake/KeikanInstall.cmake")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  string(APPEND keikan_requirements
    "set(keikan_${component}_needs ${needs})\nset(keikan_${component}_packages ${packages})\n")
endforeach()
string(REPLACE ";" " " keikan_requirements "${keikan_requirements}")
string(REPLACE ";" " " keikan_components "${components}")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/keikan)
configure_package_config_file(cmake/keikan-config.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/keikan-config.cmake"
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/keikan-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/keikan-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/keikan-config-version.cmake" DESTINATION ${package_dir})
install(EXPORT keikan-targets NAMESPACE keikan:: DESTINATION ${package_dir})
install(DIRECTORY include/keikan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The programs. keikan-verify is under another licence, so its text goes beside it.
set(programs "")
get_property(program_targets GLOBAL PROPERTY KEIKAN_PROGRAMS)
foreach(program keikan keikan-import keikan-verify keikan_app keikan_import keikan_verify ${program_targets})
  if(TARGET ${program})
    get_target_property(type ${program} TYPE)
    if(type STREQUAL "EXECUTABLE")
      list(APPEND programs ${program})
    endif()
  endif()
endforeach()
if(programs)
  list(REMOVE_DUPLICATES programs)
  install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(KEIKAN_VERIFY)
  install(FILES LICENSES/GPL-3.0-or-later.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
