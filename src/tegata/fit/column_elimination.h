// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace tegata {

/// The first columns of H x = -g, H symmetric and positive, eliminated one after the other: L D L^T
/// without exchanging anything, which damping makes safe. Of H there is what is on and below the
/// diagonal, g is its last row. For the few dozen rows of a fit: all memory is inside, and what is
/// multiplied runs along columns, four rows at once.
template <int kMostColumns, int kMostRows>
class ColumnElimination {
 public:
  /// Of so many rows, the gradient's included. Columns are to be filled before they are eliminated.
  explicit ColumnElimination(Eigen::Index rows) : rows_(rows) {
    values_.middleRows(rows, kLanes - 1).setZero();
  }

  /// A column from its first row on; what is above the diagonal is never looked at.
  auto column(Eigen::Index j) { return values_.col(j).head(rows_); }
  auto column(Eigen::Index j) const { return values_.col(j).head(rows_); }

  /// Marquardt's damping of `count` columns scales with the diagonal; the floor keeps a parameter
  /// that nothing is known of from making the matrix singular.
  void damp(Eigen::Index count, double damping) {
    auto diagonal = values_.diagonal().head(count);
    const double floor = 1e-12 * diagonal.maxCoeff() + 1e-300;
    diagonal += (damping * diagonal.array() + floor).matrix();
  }

  void eliminate(Eigen::Index count) {
    for (count_ = 0; count_ < count; ++count_) {
      subtract_from(*this, count_, count_);
      const double pivot = values_(count_, count_);
      inverse_pivots_[count_] = pivot > 0.0 ? 1.0 / pivot : 0.0;
    }
  }

  /// Takes what the eliminated columns hold of row `row` and those below it from a column of what
  /// is left, which has that row on its diagonal.
  template <typename Left>
  void subtract_from(Left& left, Eigen::Index column, Eigen::Index row) const {
    Eigen::Matrix<double, kMostColumns, 1> factors;
    for (Eigen::Index k = 0; k < count_; ++k) factors[k] = values_(row, k) * inverse_pivots_[k];
    double* const diagonal = &left.values_(column, column);
    for (Eigen::Index i = row; i < rows_; i += kLanes) {
      Eigen::Map<FourRows> rows(diagonal + (i - row));
      FourRows sum = rows;
      Eigen::Index k = 0;
      for (; k + 1 < count_; k += 2) {  // by twos, as each difference waits for the one before
        sum -= factors[k] * part(k, i) + factors[k + 1] * part(k + 1, i);
      }
      if (k < count_) sum -= factors[k] * part(k, i);
      rows = sum;
    }
  }

  /// Finds the first entries of x, as many as columns are eliminated, from those after them.
  template <typename Solution>
  void substitute_back(Solution& x) const {
    for (Eigen::Index j = count_; j-- > 0;) {
      const Eigen::Index below = rows_ - 2 - j;
      const double known = values_.col(j).segment(j + 1, below).dot(x.segment(j + 1, below));
      x[j] = -inverse_pivots_[j] * (values_(rows_ - 1, j) + known);
    }
  }

 private:
  using FourRows = Eigen::Array<double, 4, 1>;

  Eigen::Map<const FourRows> part(Eigen::Index column, Eigen::Index row) const {
    return Eigen::Map<const FourRows>(values_.col(column).data() + row);
  }

  template <int kColumns, int kRows>
  friend class ColumnElimination;
  static constexpr int kLanes = 4;

  Eigen::Index rows_, count_ = 0;
  Eigen::Matrix<double, kMostRows + kLanes - 1, kMostColumns> values_;  // with room for the lanes
  Eigen::Matrix<double, kMostColumns, 1> inverse_pivots_;
};

}  // namespace tegata
