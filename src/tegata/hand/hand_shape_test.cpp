// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/hand_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "tegata/base/error.h"
#include "tegata/hand/hand_model.h"

namespace tegata {
namespace {

/// The middle of a digit's pad and the way it faces.
struct Pad {
  Eigen::Vector3d place, facing;
};

Pad pad(const Skeleton& skeleton, const JointAngles& angles, std::size_t digit) {
  const Rigid3d bone = bone_transforms(skeleton, angles)[3 + 3 * digit];
  const Eigen::Vector3d tip = skeleton.keypoints[4 + 4 * digit];
  const Eigen::Vector3d along = (tip - skeleton.keypoints[3 + 4 * digit]).normalized();
  const Eigen::Vector3d facing = skeleton.axes[3 + 4 * digit].cross(along);
  return {bone * Eigen::Vector3d(tip - 0.009 * along + 0.007 * facing), bone.rotation * facing};
}

/// The thumb and a finger brought pad to pad by steps along single angles, within the limits.
JointAngles pinch(const Skeleton& skeleton, std::size_t digit) {
  JointAngles angles = JointAngles::Zero();
  angles.head<2>() << 0.8, 0.3;
  const auto cost = [&] {
    const Pad thumb = pad(skeleton, angles, 0), finger = pad(skeleton, angles, digit);
    return (thumb.place - finger.place).norm() + 0.005 * thumb.facing.dot(finger.facing);
  };
  for (double step = 0.4; step > 1e-3; step *= 0.85) {
    for (int angle = 0; angle < kAngleCount; ++angle) {
      for (const double change : {step, -step}) {
        const double before = cost(), kept = angles[angle];
        angles[angle] =
            std::clamp(kept + change, angle_limits().lower[angle], angle_limits().upper[angle]);
        if (cost() >= before) angles[angle] = kept;
      }
    }
  }
  return angles;
}

TEST(HandShape, LengthIsFromTheWristToTheMiddleTip) {
  for (const double length : {0.165, 0.189, 0.21}) {
    HandShape shape;
    shape.length = length;
    const Skeleton skeleton = right_skeleton(shape);
    EXPECT_LT((skeleton.keypoints[12] - Eigen::Vector3d(0.0, length, 0.0)).norm(), 1e-12);
  }
}

TEST(HandShape, FrameIsThatOfTheHeader) {
  const Skeleton skeleton = right_skeleton(HandShape());
  EXPECT_EQ(skeleton.keypoints[0], Eigen::Vector3d::Zero());
  EXPECT_NEAR(skeleton.keypoints[9].x(), 0.0, 1e-12);
  EXPECT_NEAR(skeleton.keypoints[9].z(), 0.0, 1e-12);
  for (std::size_t mcp = 5; mcp < 17; mcp += 4) {
    EXPECT_LT(skeleton.keypoints[mcp].x(), skeleton.keypoints[mcp + 4].x());
  }
  EXPECT_LT(skeleton.keypoints[4].x(), -0.05) << "the thumb is on the radial side";
}

TEST(HandShape, ZeroIsTheFlatHand) {
  const Skeleton skeleton = right_skeleton(HandShape());
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    const Eigen::Vector3d first = skeleton.keypoints[1 + 4 * digit];
    const Eigen::Vector3d along = (skeleton.keypoints[4 + 4 * digit] - first).normalized();
    EXPECT_NEAR(along.z(), 0.0, 1e-12);
    for (std::size_t i = 2; i < 4; ++i) {
      const Eigen::Vector3d offset = skeleton.keypoints[i + 4 * digit] - first;
      EXPECT_LT(offset.cross(along).norm(), 1e-12) << "not straight";
    }
  }
}

TEST(HandShape, FlexionGoesToThePalmAndAbductionFromTheMiddleFinger) {
  const Skeleton skeleton = right_skeleton(HandShape());
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const auto tip = static_cast<std::size_t>(4 * digit + 4);
    HandPose pose;
    pose.angles[4 * digit] = 0.3;
    const Eigen::Vector3d abducted = posed_keypoints(skeleton, pose)[tip] - skeleton.keypoints[tip];
    pose.angles[4 * digit] = 0.0;
    pose.angles[4 * digit + 1] = 0.3;
    const Eigen::Vector3d flexed = posed_keypoints(skeleton, pose)[tip] - skeleton.keypoints[tip];
    if (digit == 0) {
      EXPECT_LT(abducted.z(), -0.02) << "away from the palm";
      EXPECT_GT(flexed.x(), 0.01) << "across the palm";
    } else {
      EXPECT_GT(abducted.x() * (digit <= 2 ? -1.0 : 1.0), 0.015);
      EXPECT_LT(flexed.z(), -0.015);
    }
  }
}

// What makes a hand one: the pad of the thumb meets that of each finger (Kapandji 1986). The palm's
// arch does not deepen here as it does in life, so the little finger's is met only nearly.
TEST(HandShape, ThumbOpposesEveryFinger) {
  const Skeleton skeleton = right_skeleton(HandShape());
  for (std::size_t digit = 1; digit < kDigitCount; ++digit) {
    const JointAngles angles = pinch(skeleton, digit);
    const Pad thumb = pad(skeleton, angles, 0), finger = pad(skeleton, angles, digit);
    EXPECT_LT((thumb.place - finger.place).norm(), digit < 4 ? 0.005 : 0.012) << digit;
    if (digit == 1) {
      EXPECT_LT(thumb.facing.dot(finger.facing), -0.4);
    }
  }
}

TEST(HandShape, InTheFlatHandAllPadsAreOnThePalmsSide) {
  const Skeleton skeleton = right_skeleton(HandShape());
  for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
    EXPECT_LT(pad(skeleton, JointAngles::Zero(), digit).facing.z(), digit == 0 ? -0.2 : -0.9);
  }
}

TEST(HandShape, PercentilesAreThoseOfTheSurveys) {
  const HandShape woman = HandShape::percentile(50, Sex::female);
  EXPECT_NEAR(woman.length, 0.1805, 1e-6);
  EXPECT_NEAR(woman.palm_breadth, 0.0794, 1e-6);
  const HandShape man = HandShape::percentile(95, Sex::male);
  EXPECT_NEAR(man.length, 0.1938 + 1.6449 * 0.0098, 1e-6);
  EXPECT_GT(man.palm_thickness, woman.palm_thickness);
  EXPECT_NO_THROW(check_shape(man));
}

TEST(HandShape, PercentilesMirrorAboutTheMedian) {
  const double low = HandShape::percentile(10, Sex::male).length;
  const double high = HandShape::percentile(90, Sex::male).length;
  EXPECT_NEAR(0.5 * (low + high), HandShape::percentile(50, Sex::male).length, 1e-9);
}

TEST(HandShape, RefusesPercentilesWithoutAHand) {
  for (const double percentile : {0.0, 100.0, -3.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(HandShape::percentile(percentile, Sex::male), Error);
  }
}

TEST(HandShape, BonesHaveTheLengthsAskedFor) {
  HandShape shape;
  shape.bone_lengths[4] = 1.25;
  shape.palm_length = 1.1;
  const Skeleton mean = right_skeleton(HandShape()), other = right_skeleton(shape);
  for (int bone = 1; bone < kBoneCount; ++bone) {
    const auto far = static_cast<std::size_t>(distal_keypoint(bone));
    const double length = (other.keypoints[far] - other.keypoints[far - 1]).norm();
    EXPECT_NEAR(length, bone_length(shape, bone), 1e-12);
    EXPECT_NEAR(length,
                (bone == 5 ? 1.25 : 1.0) * (mean.keypoints[far] - mean.keypoints[far - 1]).norm(),
                1e-12);
  }
  EXPECT_NEAR(other.keypoints[9].y(), 1.1 * mean.keypoints[9].y(), 1e-12);
}

TEST(CheckShape, NamesTheSizeThatIsNotAHands) {
  HandShape shape;
  shape.palm_breadth = 84.0;
  try {
    check_shape(shape);
    FAIL() << "millimetres were taken for metres";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("palm_breadth"), std::string::npos);
  }
  shape = HandShape();
  shape.length = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_shape(shape), Error);
}

}  // namespace
}  // namespace tegata
