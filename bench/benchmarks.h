// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The benchmarks. Each prints a section of Markdown and returns whether its checks
// hold.
#pragma once

namespace tegata::bench {

/// B1: silhouettes to the octree's leaves, tables included.
bool benchmark_hull();
/// B2: the field to a closed surface.
bool benchmark_isosurface();
/// B3: the surface to 4,000 triangles.
bool benchmark_simplify();
/// B4: nearest points.
bool benchmark_closest_point();
/// B5: a hand to planes, in one frame.
bool benchmark_fit();
/// B6: the same in many frames at once, with one set of angles.
bool benchmark_joint();
/// Thirty frames with one set of angles from near by, hulls first, then contours.
bool benchmark_refine();
/// A hand posed with its derivatives.
bool benchmark_hand();
/// Silhouettes to 4,000 triangles, step by step.
bool benchmark_chain();
/// B7: silhouettes of a moving hand to its joint angles.
bool benchmark_track();
/// Three streams of pictures to undistorted silhouettes.
bool benchmark_segmentation();
/// How much memory the finest hulls take at their peak.
bool benchmark_memory();

}  // namespace tegata::bench
