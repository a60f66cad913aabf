// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/sim/grasps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tegata/base/angle.h"
#include "tegata/base/error.h"
#include "tegata/base/random.h"
#include "tegata/math/so3.h"

namespace tegata {
namespace {

constexpr int kThumb = 0, kIndex = 1, kMiddle = 2, kRing = 3, kLittle = 4;

constexpr std::array<std::pair<SimulatedGrasp, std::string_view>, 4> kGraspNames = {{
    {SimulatedGrasp::cylinder, "cylinder"},
    {SimulatedGrasp::sphere, "sphere"},
    {SimulatedGrasp::pinch, "pinch"},
    {SimulatedGrasp::lateral, "lateral"},
}};

// Where the digits would go with nothing in the way [deg].
using Posture = std::array<std::array<double, 4>, kDigitCount>;
constexpr Posture kAroundCylinder = {{{48.0, 20.0, 20.0, 25.0},
                                      {0.0, 60.0, 65.0, 38.0},
                                      {0.0, 62.0, 68.0, 40.0},
                                      {2.0, 64.0, 68.0, 40.0},
                                      {5.0, 66.0, 65.0, 40.0}}};
constexpr Posture kAroundSphere = {{{50.0, 12.0, 15.0, 20.0},
                                    {10.0, 42.0, 48.0, 28.0},
                                    {0.0, 45.0, 50.0, 30.0},
                                    {8.0, 46.0, 50.0, 30.0},
                                    {15.0, 46.0, 48.0, 28.0}}};
constexpr Posture kPinching = {{{54.0, 8.0, 12.0, 18.0},
                                {0.0, 56.0, 34.0, 16.0},
                                {0.0, 60.0, 36.0, 18.0},
                                {2.0, 42.0, 45.0, 20.0},
                                {6.0, 42.0, 45.0, 20.0}}};
constexpr Posture kLateral = {{{20.0, 10.0, 15.0, 20.0},
                               {0.0, 42.0, 58.0, 28.0},
                               {0.0, 52.0, 66.0, 34.0},
                               {2.0, 58.0, 70.0, 36.0},
                               {5.0, 62.0, 70.0, 36.0}}};

// The digits of a right hand, the angles found so far, and where the seed's variation comes from.
class ClosingHand {
 public:
  ClosingHand(const HandModel& hand, const Posture& posture, Random& random) : hand_(&hand) {
    for (int digit = 0; digit < kDigitCount; ++digit) surfaces_.emplace_back(hand, digit);
    for (int angle = 0; angle < kAngleCount; ++angle) {
      const double varied =
          posture[static_cast<std::size_t>(angle / 4)][static_cast<std::size_t>(angle % 4)] +
          random.uniform(-4.0, 4.0) * (angle % 4 == 0 ? 0.5 : 1.0);
      preferred_[angle] = varied * kDegree;
    }
    settle();
  }

  const HandModel& hand() const { return *hand_; }
  const JointAngles& angles() const { return angles_; }
  JointAngles& preferred() { return preferred_; }
  // Puts all digits where they would go with nothing in the way.
  void settle() {
    angles_ = preferred_.cwiseMax(angle_limits().lower).cwiseMin(angle_limits().upper);
  }
  const DigitSurface& surface(int digit) const {
    return surfaces_[static_cast<std::size_t>(digit)];
  }

  // Closes one digit among others that are where they shall be.
  void close(int digit, const std::vector<int>& others, DigitGoal goal, const PlacedObject& held) {
    std::vector<const DigitSurface*> surfaces;
    for (const int other : others) surfaces.push_back(&surface(other));
    goal.preferred = preferred_.segment<4>(4 * digit);
    angles_ = closed_digit(*hand_, surface(digit), surfaces, goal, held, angles_);
  }

  // The middle finger first, the thumb last, each beside those that are closed already.
  void close_all(const DigitGoal& finger, const DigitGoal& thumb, const PlacedObject& held) {
    close(kMiddle, {}, finger, held);
    close(kIndex, {kMiddle}, finger, held);
    close(kRing, {kMiddle}, finger, held);
    close(kLittle, {kRing}, finger, held);
    close(kThumb, {kIndex, kMiddle, kRing}, thumb, held);
  }

 private:
  const HandModel* hand_;
  std::vector<DigitSurface> surfaces_;
  JointAngles preferred_, angles_;
};

Eigen::Vector3d joint(const HandModel& hand, int digit, int bone_of_digit) {
  return hand.skeleton.keypoints[static_cast<std::size_t>(1 + 4 * digit + bone_of_digit)];
}

// The least distance of an object to the skin of the palm and of the fingers' roots.
double clearance_of_palm(const HandModel& hand, const JointAngles& angles,
                         const PlacedObject& held) {
  const PosedHand posed(hand, HandPose{{}, angles});
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
    const int bone = main_bone(hand.links[i]);
    const bool is_root_of_finger = bone > 1 && bone % 3 == 1;
    if (bone != 0 && !is_root_of_finger) continue;
    least = std::min(least, held.distance(posed.vertices()[i]));
  }
  return least;
}

// Moves an object up to the palm of the flat hand, along the hand's z, until it presses half a
// millimetre into the skin.
void press_into_palm(const HandModel& hand, PlacedObject& held) {
  constexpr double kPress = 0.5e-3, kFar = -0.2;  // [m]
  double low = kFar, high = 0.0;
  while (high - low > 1e-4) {
    held.hand_from_object.translation.z() = 0.5 * (low + high);
    const bool too_near = clearance_of_palm(hand, JointAngles::Zero(), held) < -kPress;
    (too_near ? high : low) = held.hand_from_object.translation.z();
  }
}

// Closes all digits on an object that lies in the palm. Skin that folds as the fingers bend may
// push into it; then it gives way and the digits close anew.
Grasp wrapped(ClosingHand& closing, PlacedObject held) {
  constexpr int kMostTries = 4;
  constexpr double kDeepest = 1.2e-3;  // [m]
  DigitGoal thumb;
  thumb.contact = {0.05, 0.4, 1.0};
  press_into_palm(closing.hand(), held);
  for (int tries = 0; tries < kMostTries; ++tries) {
    closing.settle();
    closing.close_all(DigitGoal{}, thumb, held);
    const double depth = -clearance_of_palm(closing.hand(), closing.angles(), held);
    if (depth < kDeepest) break;
    held.hand_from_object.translation.z() -= depth;
  }
  return {closing.angles(), held};
}

Grasp cylinder_grasp(const HandModel& hand, Random& random) {
  ClosingHand closing(hand, kAroundCylinder, random);
  const double radius = random.uniform(0.020, 0.035);
  PlacedObject held;
  held.object = {HeldObject::Shape::cylinder, {radius, radius, random.uniform(0.055, 0.08)}};
  // Across the palm under the knuckles, the little finger's end nearer to the wrist.
  const Eigen::Vector3d row = joint(hand, kLittle, 0) - joint(hand, kIndex, 0);
  const double tilt = random.uniform(2.0, 12.0) * kDegree;
  const Eigen::Vector3d axis =
      so3_exp({0.0, 0.0, -tilt}) * Eigen::Vector3d(row.x(), row.y(), 0.0).normalized();
  held.hand_from_object.rotation =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
  held.hand_from_object.translation = 0.5 * (joint(hand, kMiddle, 0) + joint(hand, kRing, 0)) -
                                      random.uniform(0.004, 0.012) * Eigen::Vector3d::UnitY() +
                                      random.uniform(-0.012, 0.012) * axis;
  return wrapped(closing, held);
}

Grasp sphere_grasp(const HandModel& hand, Random& random) {
  ClosingHand closing(hand, kAroundSphere, random);
  const double radius = random.uniform(0.028, 0.040);
  PlacedObject held;
  held.object = {HeldObject::Shape::sphere, Eigen::Vector3d::Constant(radius)};
  held.hand_from_object.translation =
      0.6 * joint(hand, kMiddle, 0) + 0.2 * (joint(hand, kIndex, 0) + joint(hand, kRing, 0)) +
      Eigen::Vector3d(random.uniform(-0.006, 0.002), random.uniform(-0.006, 0.006), 0.0);
  return wrapped(closing, held);
}

// A fingertip's pad: where it is, which way it faces, and the tip itself, in the hand's frame.
struct Pad {
  Eigen::Vector3d point, facing, tip;
};

Pad pad_of(const HandModel& hand, const DigitSurface& surface, const JointAngles& angles) {
  constexpr double kFromTip = 0.4;  // of the last bone
  const auto keypoints = posed_keypoints(hand.skeleton, HandPose{{}, angles});
  const auto tip = static_cast<std::size_t>(4 + 4 * surface.digit());
  const Eigen::Vector3d along = keypoints[tip] - keypoints[tip - 1];
  const Eigen::Vector3d axis =
      joint_axes(hand.skeleton, angles)[static_cast<std::size_t>(4 * surface.digit() + 3)]
          .direction;
  const Eigen::Vector3d facing = axis.cross(along).normalized();  // where flexion takes the tip
  return {keypoints[tip] - kFromTip * along + surface.radius(2) * facing, facing, keypoints[tip]};
}

// Between the pads of index and middle finger and where the thumb's would meet them.
PlacedObject object_before_pads(const HandModel& hand, const ClosingHand& closing,
                                const HeldObject& object) {
  const Pad index = pad_of(hand, closing.surface(kIndex), closing.angles());
  const Pad middle = pad_of(hand, closing.surface(kMiddle), closing.angles());
  const Eigen::Vector3d facing = (index.facing + middle.facing).normalized();
  const Eigen::Vector3d apart = middle.point - index.point;
  Eigen::Matrix3d axes;
  axes.col(2) = facing;
  axes.col(0) = (apart - apart.dot(facing) * facing).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  PlacedObject held;
  held.object = object;
  held.hand_from_object = {Eigen::Quaterniond(axes),
                           0.5 * (index.point + middle.point) + object.half_size.z() * facing};
  return held;
}

struct Pinch {
  ClosingHand closing;
  PlacedObject held;
  double miss = 0.0;  // how far the thumb's pad is from where it shall be, and faces away [m]
};

// Lays the object before the pads of index and middle finger as they are preferred to be, and
// closes the three digits on it.
Pinch pinch_from(ClosingHand closing, const HeldObject& object) {
  closing.settle();
  const PlacedObject held = object_before_pads(closing.hand(), closing, object);
  const Eigen::Vector3d facing = held.hand_from_object.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d middle_of_face =
      held.hand_from_object.translation + object.half_size.z() * facing;
  DigitGoal finger, thumb;
  finger.contact = thumb.contact = {0.0, 0.0, 4.0};
  thumb.tip_target = middle_of_face + closing.surface(kThumb).radius(2) * facing;
  closing.close(kMiddle, {}, finger, held);
  closing.close(kIndex, {kMiddle}, finger, held);
  closing.close(kThumb, {kIndex, kMiddle}, thumb, held);
  const Pad pad = pad_of(closing.hand(), closing.surface(kThumb), closing.angles());
  const bool is_beside = (pad.tip - middle_of_face).dot(facing) < 0.0;
  const double miss = (pad.point - middle_of_face).norm() + 0.02 * (1.0 + pad.facing.dot(facing)) +
                      (is_beside ? 0.1 : 0.0);
  return {closing, held, miss};
}

Grasp pinch_grasp(const HandModel& hand, Random& random) {
  const ClosingHand closing(hand, kPinching, random);
  HeldObject object;
  const double half_thickness = 0.5 * random.uniform(0.010, 0.025);
  if (random.index(2) == 0) {
    const double radius = random.uniform(0.013, 0.018);
    object = {HeldObject::Shape::cylinder, {radius, radius, half_thickness}};
  } else {
    const double half_breadth = random.uniform(0.013, 0.018);
    object = {HeldObject::Shape::block,
              {half_breadth, random.uniform(0.009, 0.013), half_thickness}};
  }
  // The more the fingers bend at the knuckles, the nearer the object comes to the thumb: takes the
  // bend at which the thumb's pad reaches it best.
  std::optional<Pinch> best;
  for (double bend = -18.0; bend <= 12.0; bend += 6.0) {
    ClosingHand bent = closing;
    for (const int digit : {kIndex, kMiddle}) {
      bent.preferred()[4 * digit + 1] += bend * kDegree;
      bent.preferred()[4 * digit + 2] -= 0.7 * bend * kDegree;
    }
    const Pinch pinch = pinch_from(bent, object);
    if (!best || pinch.miss < best->miss) best.emplace(pinch);
  }
  // The other two only keep out of the way.
  DigitGoal idle;
  idle.contact.setZero();
  best->closing.close(kRing, {kMiddle, kThumb}, idle, best->held);
  best->closing.close(kLittle, {kRing}, idle, best->held);
  return {best->closing.angles(), best->held};
}

struct LateralGrip {
  ClosingHand closing;
  PlacedObject held;
  double miss = 0.0;  // how far the thumb's pad is from the plate's middle line, and faces away [m]
};

// Lays a plate against the side of the index finger that faces the thumb, `along` of the way from
// its PIP to its DIP joint, and closes the thumb on it. Most of the plate sticks out beyond both.
LateralGrip lateral_from(ClosingHand closing, const HeldObject& object, double along) {
  constexpr double kOut = 0.6;  // of the plate's half length is in front of the finger
  closing.settle();
  const auto keypoints = posed_keypoints(closing.hand().skeleton, HandPose{{}, closing.angles()});
  const Eigen::Vector3d pip = keypoints[4 * kIndex + 2], dip = keypoints[4 * kIndex + 3];
  const auto flexion =
      joint_axes(closing.hand().skeleton, closing.angles())[4 * kIndex + 2].direction;
  const Eigen::Vector3d bone = (dip - pip).normalized();
  // Of the two ways along the flexion axis that away from the middle finger.
  const Eigen::Vector3d sideways = flexion - flexion.dot(bone) * bone;
  const double sign = sideways.dot(keypoints[4 * kMiddle + 2] - pip) > 0.0 ? -1.0 : 1.0;
  Eigen::Matrix3d axes;
  axes.col(2) = sign * sideways.normalized();
  axes.col(0) = bone;
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const double radius = closing.surface(kIndex).radius(1);
  const Eigen::Vector3d gripped =
      pip + along * (dip - pip) + (radius + object.half_size.z()) * axes.col(2);
  PlacedObject held;
  held.object = object;
  held.hand_from_object = {Eigen::Quaterniond(axes),
                           gripped + kOut * object.half_size.x() * axes.col(0)};
  DigitGoal finger, thumb, beside;
  beside.contact.setZero();
  finger.contact = {0.0, 4.0, 0.0};
  thumb.contact = {0.0, 0.0, 4.0};
  const Eigen::Vector3d face = gripped + object.half_size.z() * axes.col(2);
  thumb.tip_target = face + closing.surface(kThumb).radius(2) * axes.col(2);
  closing.close(kMiddle, {}, beside, held);
  closing.close(kIndex, {kMiddle}, finger, held);
  closing.close(kThumb, {kIndex, kMiddle}, thumb, held);
  const Pad pad = pad_of(closing.hand(), closing.surface(kThumb), closing.angles());
  const double gap = std::abs(closing.surface(kThumb).clearances(closing.angles(), held)[2]) +
                     std::abs(closing.surface(kIndex).clearances(closing.angles(), held)[1]);
  const double miss =
      (pad.point - face).norm() + 0.02 * (1.0 + pad.facing.dot(axes.col(2))) + 4.0 * gap;
  return {closing, held, miss};
}

Grasp lateral_grasp(const HandModel& hand, Random& random) {
  const ClosingHand closing(hand, kLateral, random);
  const HeldObject object = {HeldObject::Shape::block,
                             {random.uniform(0.022, 0.032), random.uniform(0.011, 0.015),
                              0.5 * random.uniform(0.002, 0.005)}};
  // Where along the finger, and how bent it is, so that the thumb's pad reaches the plate best.
  std::optional<LateralGrip> best;
  for (double bend = -16.0; bend <= 16.0; bend += 8.0) {
    ClosingHand bent = closing;
    for (const int digit : {kIndex, kMiddle}) bent.preferred()[4 * digit + 1] += bend * kDegree;
    for (const double along : {0.1, 0.5, 0.9}) {
      const LateralGrip grip = lateral_from(bent, object, along);
      if (!best || grip.miss < best->miss) best.emplace(grip);
    }
  }
  DigitGoal idle;
  idle.contact.setZero();
  best->closing.close(kRing, {kMiddle, kThumb}, idle, best->held);
  best->closing.close(kLittle, {kRing}, idle, best->held);
  return {best->closing.angles(), best->held};
}

// Objects are their own mirror images, so only where they lie changes.
Grasp mirrored(const Grasp& grasp) {
  Grasp other = grasp;
  Rigid3d& placed = other.held.hand_from_object;
  placed.translation.x() = -placed.translation.x();
  placed.rotation.y() = -placed.rotation.y();
  placed.rotation.z() = -placed.rotation.z();
  return other;
}

Grasp right_hand_grasp(const HandModel& hand, SimulatedGrasp kind, std::uint64_t seed) {
  Random random(seed);
  switch (kind) {
    case SimulatedGrasp::cylinder:
      return cylinder_grasp(hand, random);
    case SimulatedGrasp::sphere:
      return sphere_grasp(hand, random);
    case SimulatedGrasp::lateral:
      return lateral_grasp(hand, random);
    case SimulatedGrasp::pinch:
      break;
  }
  return pinch_grasp(hand, random);
}

}  // namespace

std::string_view simulated_grasp_name(SimulatedGrasp grasp) {
  for (const auto& [named, name] : kGraspNames) {
    if (named == grasp) return name;
  }
  throw Error("simulated take: got grasp number ", static_cast<int>(grasp),
              ", expected a known one");
}

SimulatedGrasp simulated_grasp_from_name(std::string_view name) {
  for (const auto& [grasp, its_name] : kGraspNames) {
    if (its_name == name) return grasp;
  }
  throw Error("simulated take: got grasp '", name,
              "', expected cylinder, sphere, pinch or lateral");
}

Grasp make_grasp(const HandModel& hand, SimulatedGrasp kind, std::uint64_t seed) {
  if (hand.skeleton.side == Side::right) return right_hand_grasp(hand, kind, seed);
  return mirrored(right_hand_grasp(mirrored(hand), kind, seed));
}

}  // namespace tegata
