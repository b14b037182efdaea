# SPDX-License-Identifier: Apache-2.0
# find_package(keikan) from outside: see tests/consumer.
include(CMakePackageConfigHelpers)
install(DIRECTORY include/keikan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT keikan-targets NAMESPACE keikan:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/keikan)
