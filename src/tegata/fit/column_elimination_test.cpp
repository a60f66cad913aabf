// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/column_elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tegata/base/random.h"

namespace tegata {
namespace {

using Elimination = ColumnElimination<8, 9>;

// A symmetric, positive matrix with the gradient as its last row.
Eigen::MatrixXd random_system(Eigen::Index size, Random& random) {
  Eigen::MatrixXd rows(3 * size, size + 1);
  for (double& value : rows.reshaped()) value = random.normal();
  const Eigen::MatrixXd products = rows.transpose() * rows;
  return products.leftCols(size);
}

TEST(ColumnElimination, AgreesWithCholeskyWhateverTheRowsThatAreLeftOfFour) {
  Random random(5);
  for (Eigen::Index size = 1; size <= 8; ++size) {
    const Eigen::MatrixXd system = random_system(size, random);
    Elimination elimination(size + 1);
    for (Eigen::Index j = 0; j < size; ++j) {
      elimination.column(j).tail(size + 1 - j) = system.col(j).tail(size + 1 - j);
    }
    elimination.eliminate(size);
    Eigen::VectorXd found(size);
    elimination.substitute_back(found);
    const Eigen::VectorXd expected =
        system.topRows(size).llt().solve(-system.row(size).transpose());
    EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm()) << size;
  }
}

TEST(ColumnElimination, EveryInstructionSetGivesTheSameBits) {
  Random random(7);
  const Eigen::MatrixXd system = random_system(8, random);
  // Five columns of eight, then what they leave of the other three.
  const auto solved = [&](InstructionSet set) {
    ColumnElimination<5, 9> first(9, set);
    Elimination second(4, set);
    for (Eigen::Index j = 0; j < 5; ++j) first.column(j) = system.col(j);
    for (Eigen::Index j = 0; j < 3; ++j) second.column(j) = system.col(5 + j).tail(4);
    first.eliminate(5);
    first.subtract_from(second, 3, 5);
    second.eliminate(3);
    Eigen::VectorXd found(8), last(3);
    second.substitute_back(last);
    found.tail(3) = last;
    first.substitute_back(found);
    return found;
  };
  const Eigen::VectorXd baseline = solved(InstructionSet::baseline);
  const Eigen::VectorXd expected = system.topRows(8).llt().solve(-system.row(8).transpose());
  EXPECT_LT((baseline - expected).norm(), 1e-10 * expected.norm());
  for (const InstructionSet set : kInstructionSets) {
    if (!is_supported(set)) continue;
    EXPECT_EQ(solved(set), baseline) << instruction_set_name(set);
  }
}

TEST(ColumnElimination, AColumnOfZerosIsLeftAtZero) {
  Random random(6);
  Eigen::MatrixXd system = random_system(3, random);
  system.col(1).setZero();
  system.row(1).setZero();
  Elimination elimination(4);
  for (Eigen::Index j = 0; j < 3; ++j) elimination.column(j) = system.col(j);
  elimination.eliminate(3);
  Eigen::VectorXd found(3);
  elimination.substitute_back(found);
  EXPECT_EQ(found[1], 0.0);
  EXPECT_TRUE(found.allFinite());
}

}  // namespace
}  // namespace tegata
