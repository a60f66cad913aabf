// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Seeds of the fuzz targets in files that other tools write.
#pragma once

namespace tegata {

// What this project reads and does not write: text, polygons, other properties, comments.
inline constexpr const char* kAsciiPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nproperty uchar red\nelement face 1\n"
    "property list uchar uint vertex_index\nelement edge 1\nproperty int vertex1\n"
    "end_header\n0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n4 0 1 2 3\n7\n";

// The same two cameras as other tools write them; | stands for the zero byte between two files.
inline constexpr const char* kColmap =
    "# cameras\n1 OPENCV 640 480 700 700 320 240 -0.1 0.01 0 0\n"
    "2 SIMPLE_RADIAL 640 480 700 320 240 -0.1\n|1 1 0 0 0 0 0 1 1 a.png\n1 2 -1\n"
    "2 0.7 0 0.714142842854285 0 0 0 1 2 b.png\n\n";
inline constexpr const char* kEasyMocap =
    "%YAML:1.0\n---\nnames:\n  - \"01\"\n  - \"02\"\nK_01: !!opencv-matrix\n  rows: 3\n"
    "  cols: 3\n  dt: d\n  data: [ 700., 0., 320., 0., 700., 240., 0., 0., 1. ]\n"
    "dist_01: [0, 0, 0, 0, 0]\nR_01: [0.1, 0, 0]\nT_01: [0, 0, 1]\nH_01: 480\nW_01: 640\n"
    "K_02: [700, 0, 320, 0, 700, 240, 0, 0, 1]\ndist_02: [0, 0, 0, 0, 0]\n"
    "Rot_02: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT_02: [0, 0, 1]\n";
inline constexpr const char* kKalibr =
    "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0, 0, 0]\n"
    "  distortion_model: equidistant\n  intrinsics: [700, 700, 320, 240]\n"
    "  resolution: [640, 480]\ncam1:\n  T_cn_cnm1:\n  - [1, 0, 0, 0.1]\n  - [0, 1, 0, 0]\n"
    "  - [0, 0, 1, 0]\n  - [0, 0, 0, 1]\n  camera_model: pinhole\n"
    "  distortion_coeffs: [0.1, 0, 0, 0]\n  distortion_model: radtan\n"
    "  intrinsics: [700, 700, 320, 240]\n  resolution: [640, 480]\n";
inline constexpr const char* kOpenCvXml =
    "<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- two -->\n<a><name>\"left\"</name>"
    "<image_width>640</image_width><image_height>480</image_height>\n"
    "<camera_matrix type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt>\n"
    "<data>700. 0. 320. 0. 700. 240. 0. 0. 1.</data></camera_matrix>\n"
    "<distortion_coefficients>0 0 0 0</distortion_coefficients><R>0 0 0</R><T>0 0 1</T></a>\n"
    "<b><K>700. 0. 320. 0. 700. 240. 0. 0. 1.</K><D>0. 0. 0. 0.</D><R>0 0.1 0</R>"
    "<T><_>0</_><_>0</_><_>1</_></T></b></opencv_storage>\n";

inline constexpr const char* kOpenCvStereo =
    "%YAML:1.0\n---\nM1: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
    "  data: [ 700., 0., 320., 0., 700., 240., 0., 0., 1. ]\nD1: [0.1, 0, 0, 0]\n"
    "M2: [700, 0, 320, 0, 700, 240, 0, 0, 1]\nD2: [0, 0, 0, 0, 0, 0, 0, 0]\n"
    "imageSize: [640, 480]\n|%YAML:1.0\n---\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [0.1, 0, 0]\n";
inline constexpr const char* kOpenCvJson =
    "{\"cameras\": [{\"name\": \"a\", \"K\": [[700, 0, 320], [0, 700, 240], [0, 0, 1]],\n"
    "\"dist\": [0, 0, 0, 0], \"fisheye\": true, \"resolution\": [640, 480], \"R\": [0, 0, 0],\n"
    "\"T\": [0, 0, 1]}, {\"K\": [700, 0, 320, 0, 700, 240, 0, 0, 1], \"D\": [0, 0, 0, 0],\n"
    "\"width\": 640, \"height\": 480, \"rvec\": [0.1, 0, 0], \"tvec\": [0, 0, 1]}]}\n";
// EasyMocap's two files.
inline constexpr const char* kEasyMocapPair =
    "names: [\"1\", \"2\"]\nK_1: [700, 0, 320, 0, 700, 240, 0, 0, 1]\ndist_1: [0, 0, 0, 0, 0]\n"
    "K_2: [700, 0, 320, 0, 700, 240, 0, 0, 1]\ndist_2: [0, 0, 0, 0, 0]\n|"
    "names: [\"1\", \"2\"]\nR_1: [0.1, 0, 0]\nT_1: [0, 0, 1]\nR_2: [0, 0, 0]\nT_2: [0, 0, 1]\n";

inline constexpr const char* kBoard =
    "kind = \"charuco\"\ncolumns = 5\nrows = 7\nspacing = 0.04\nmarker = 0.03\n"
    "dictionary = \"DICT_4X4_50\"\ninverted = false\n";
inline constexpr const char* kCaliscopeBoard =
    "columns = 4\nrows = 5\nboard_height = 11.0\nboard_width = 8.5\ndictionary = \"DICT_4X4_50\"\n"
    "units = \"inch\"\naruco_scale = 0.75\nsquare_size_override_cm = 5.4\ninverted = true\n";

}  // namespace tegata
