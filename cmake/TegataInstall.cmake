# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0

# Two export sets: the core library (silhouettes in, hand out; Eigen, oneTBB and meshoptimizer only)
# and, where it was built, everything with files and pictures.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tegata)

foreach(component IN ITEMS core full)
  get_property(rooms GLOBAL PROPERTY tegata_${component}_rooms)
  if(rooms)
    add_library(tegata_${component} INTERFACE)
    add_library(tegata::${component} ALIAS tegata_${component})
    set_target_properties(tegata_${component} PROPERTIES EXPORT_NAME ${component})
    target_link_libraries(tegata_${component} INTERFACE ${rooms})
    install(TARGETS tegata_${component} ${rooms} EXPORT tegata_${component}
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT tegata_${component} NAMESPACE tegata:: DESTINATION ${package_dir})
  endif()
endforeach()

if(TEGATA_PROGRAM)
  install(TARGETS tegata RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES cmake/FindOpenCVParts.cmake DESTINATION ${package_dir})
endif()
configure_package_config_file(cmake/tegataConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/tegataConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/tegataConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tegataConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/tegataConfigVersion.cmake
        DESTINATION ${package_dir})
