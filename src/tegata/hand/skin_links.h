// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "tegata/hand/hand_model.h"

namespace tegata {

/// A bone as line segments; the palm has several.
using BoneSegments = std::array<std::vector<std::array<Eigen::Vector3d, 2>>, kBoneCount>;

/// The bones of a skeleton at given angles: the palm as rays from the wrist to the first joint of
/// each digit and into each web between fingers, and the forearm's two bones, half a breadth of the
/// wrist to either side.
BoneSegments bone_segments(const Skeleton& skeleton, const JointAngles& angles,
                           double forearm_length, double wrist_half_breadth);

/// Links a point of the surface to the nearest bone and to the second nearest among those joined to
/// it (the paper, III-B-2: no finger pulls at another). The second weighs a half where both are
/// equally far and nothing from about one radius (where the palm is one of them, one and a half) on
/// either side of the joint between them, so that what lies along a bone is rigid.
SkinLinks link_to_bones(const BoneSegments& segments, const Eigen::Vector3d& point);

/// Evens out how the palm and the digits share a surface: in each round a vertex that is linked to
/// the palm shares itself as it and its neighbours do on average. Bones stay, so that still no
/// finger pulls at another, but between two fingers the palm, which both are joined to, wins. The
/// bone that weighs more comes first.
void smooth_palm_links(const TriangleMesh& surface, int rounds, std::vector<SkinLinks>& links);

}  // namespace tegata
