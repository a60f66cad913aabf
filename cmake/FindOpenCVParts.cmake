# SPDX-FileCopyrightText: 2026 The tegata authors
# SPDX-License-Identifier: Apache-2.0

# The parts of OpenCV 4 that are used, as targets opencv::<part>. Debian's OpenCVConfig.cmake comes
# only with the package that pulls in every part (VTK and Qt among them), so the parts are looked
# up one by one.
set(OpenCVParts_NAMES core imgproc imgcodecs calib3d videoio features2d aruco)
find_path(OpenCVParts_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
set(OpenCVParts_REQUIRED OpenCVParts_INCLUDE_DIR)
foreach(part IN LISTS OpenCVParts_NAMES)
  find_library(OpenCVParts_${part}_LIBRARY opencv_${part})
  list(APPEND OpenCVParts_REQUIRED OpenCVParts_${part}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVParts REQUIRED_VARS ${OpenCVParts_REQUIRED})
if(OpenCVParts_FOUND)
  foreach(part IN LISTS OpenCVParts_NAMES)
    if(NOT TARGET opencv::${part})
      add_library(opencv::${part} UNKNOWN IMPORTED)
      set_target_properties(opencv::${part} PROPERTIES
        IMPORTED_LOCATION ${OpenCVParts_${part}_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenCVParts_INCLUDE_DIR})
    endif()
  endforeach()
endif()
mark_as_advanced(${OpenCVParts_REQUIRED})
