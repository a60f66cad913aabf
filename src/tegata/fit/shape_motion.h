// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "tegata/fit/normal_equations.h"
#include "tegata/hand/hand_model.h"
#include "tegata/hand/shaped_hand.h"

namespace tegata {

/// How the vertices of a posed hand move with parameters of its shape, for the terms of the fit.
class ShapeMotion {
 public:
  virtual ~ShapeMotion() = default;
  /// d (along . vertex in world) / d shape.
  virtual ShapeRow row(std::size_t vertex, const Eigen::RowVector3d& along) const = 0;
};

/// That of a hand's scale alone, about the origin of its frame.
class ScaleMotion : public ShapeMotion {
 public:
  /// `posed` must outlive it and be of a hand that is `scale` times what has scale 1.
  ScaleMotion(const PosedHand& posed, double scale) : posed_(&posed), scale_(scale) {}
  ShapeRow row(std::size_t vertex, const Eigen::RowVector3d& along) const override;

 private:
  const PosedHand* posed_;
  double scale_;
};

/// That of all shape parameters of the built-in hand.
class ParameterMotion : public ShapeMotion {
 public:
  /// Arguments as PosedShape's, which must outlive it.
  ParameterMotion(const HandModel& model, const ShapeBasis& basis, const HandPose& pose)
      : shape_(model, basis, pose) {}
  ShapeRow row(std::size_t vertex, const Eigen::RowVector3d& along) const override;

 private:
  PosedShape shape_;
};

/// The row of a term whose hand's shape may be known: then it is empty.
inline ShapeRow shape_row(const ShapeMotion* shape, std::size_t vertex,
                          const Eigen::RowVector3d& along) {
  return shape == nullptr ? ShapeRow() : shape->row(vertex, along);
}

}  // namespace tegata
