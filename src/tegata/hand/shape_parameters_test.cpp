// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/shape_parameters.h"

#include <gtest/gtest.h>

#include <set>

#include "tegata/base/random.h"
#include "tegata/math/finite_difference.h"

namespace tegata {
namespace {

ShapeParameters random_parameters(std::uint64_t seed) {
  Random random(seed);
  ShapeParameters parameters = shape_prior().mean;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    parameters[i] += 1.5 * random.normal() * shape_prior().deviation[i];
  }
  return parameters;
}

TEST(ShapeParameters, NamesAreAllDifferent) {
  const auto& names = shape_parameter_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(names[0], "length");
  EXPECT_EQ(names[9], "little_thickness");
  EXPECT_EQ(names[10], "thumb_metacarpal_length");
  EXPECT_EQ(names[24], "little_distal_length");
  EXPECT_EQ(names[25], "index_metacarpal_length");
  EXPECT_EQ(names[kShapeParameterCount - 1], "little_metacarpal_length");
}

TEST(ShapeParameters, ShapeAndParametersAreInverse) {
  const ShapeParameters parameters = random_parameters(1);
  const ShapeParameters again = parameters_of_shape(shape_from_parameters(parameters));
  EXPECT_LT((again - parameters).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ShapeParameters, PriorsLimitsAreHandsAndHoldTheirMean) {
  const ShapePrior& prior = shape_prior();
  EXPECT_TRUE((prior.lower.array() < prior.mean.array()).all());
  EXPECT_TRUE((prior.upper.array() > prior.mean.array()).all());
  for (int i = 0; i < kShapeParameterCount; ++i) {
    for (const double value : {prior.lower[i], prior.upper[i]}) {
      ShapeParameters parameters = prior.mean;
      parameters[i] = value;
      EXPECT_NO_THROW(check_shape(shape_from_parameters(parameters)))
          << shape_parameter_names()[static_cast<std::size_t>(i)];
    }
  }
}

// A small woman's and a large man's hand are within the prior, or the estimate is drawn off them.
TEST(ShapeParameters, PriorHoldsSmallWomenAndLargeMen) {
  const ShapePrior& prior = shape_prior();
  for (const HandShape& shape :
       {HandShape::percentile(5, Sex::female), HandShape::percentile(95, Sex::male)}) {
    const ShapeParameters off =
        (parameters_of_shape(shape) - prior.mean).cwiseQuotient(prior.deviation);
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 3.0);
  }
}

TEST(ShapeParameters, ScaleIsTheLengthAlone) {
  ShapeParameters parameters = random_parameters(2);
  const ShapeDrivers before = drivers_of_shape(shape_from_parameters(parameters));
  parameters[0] *= 1.1;
  const ShapeDrivers after = drivers_of_shape(shape_from_parameters(parameters));
  EXPECT_LT((after - 1.1 * before).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ShapeParameters, DriverJacobianIsThatOfTheDrivers) {
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    const ShapeParameters at = random_parameters(seed);
    const Eigen::MatrixXd numeric = finite_difference_jacobian(
        [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
          return drivers_of_shape(shape_from_parameters(x));
        },
        at);
    EXPECT_LT((driver_jacobian(at) - numeric).cwiseAbs().maxCoeff(), 1e-7);
  }
}

}  // namespace
}  // namespace tegata
