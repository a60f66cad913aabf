// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstring>

#include "tegata/base/instruction_set.h"

namespace tegata {

/// The first columns of H x = -g, H symmetric and positive, eliminated one after the other: L D L^T
/// without exchanging anything, which damping makes safe. Of H there is what is on and below the
/// diagonal, g is its last row. For the few dozen rows of a fit: all memory is inside, and what is
/// multiplied runs along columns, by vector. Every instruction set gives the same bits; it must be
/// supported.
template <int kMostColumns, int kMostRows>
class ColumnElimination {
 public:
  /// Of so many rows, the gradient's included. Columns are to be filled before they are eliminated.
  explicit ColumnElimination(Eigen::Index rows, InstructionSet set = best_instruction_set())
      : rows_(rows), set_(set) {
    values_.middleRows(rows, kMostLanes - 1).setZero();
  }

  /// A column from its first row on; what is filled in above the diagonal is never looked at.
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
    constexpr std::array kRuns = {eliminate_baseline, eliminate_avx2, eliminate_avx512};
    kRuns[static_cast<std::size_t>(set_)](*this, count);
  }

  /// Takes what the eliminated columns hold of the rows from `row` on from as many columns, the
  /// first ones of what is left, which have these rows on their diagonals.
  template <typename Left>
  void subtract_from(Left& left, Eigen::Index count, Eigen::Index row) const {
    constexpr std::array kRuns = {subtract_baseline<Left>, subtract_avx2<Left>,
                                  subtract_avx512<Left>};
    kRuns[static_cast<std::size_t>(set_)](*this, left, count, row);
  }

  /// Finds the first entries of x, as many as columns are eliminated, from those after them.
  template <typename Solution>
  void substitute_back(Solution& x) const {
    const Eigen::Index last = rows_ - 1;
    double left[kMostColumns + kLanes - 1];
    for (Eigen::Index k = 0; k < count_; ++k) {
      double sum = *place(last, k);
      for (Eigen::Index i = count_; i < last; ++i) sum += *place(i, k) * x[i];
      left[k] = -inverse_pivots_[k] * sum;
    }
    // What is found goes into all before it at once: a sum over all found would wait for the last.
    for (Eigen::Index j = count_; j-- > 0;) {
      const double found = x[j] = left[j];
      for (Eigen::Index k = 0; k < j; k += kLanes) {
        RowVector<kLanes> rows, above;
        load(left + k, rows);
        load(place(k, j), above);
        rows -= found * above;
        store(rows, left + k);
      }
    }
  }

 private:
  template <int kColumns, int kRows>
  friend class ColumnElimination;
  static constexpr Eigen::Index kLanes = 2, kMostLanes = 8;  // of the baseline, of all

  // So many rows of a column.
  template <Eigen::Index kCount>
  struct Rows {
    using Vector [[gnu::vector_size(kCount * sizeof(double))]] = double;
  };
  template <Eigen::Index kCount>
  using RowVector = typename Rows<kCount>::Vector;

  // From and to wherever they begin, as no vector is aligned there.
  template <typename Vector>
  TEGATA_KERNEL static void load(const double* first, Vector& rows) {
    std::memcpy(&rows, first, sizeof rows);
  }
  template <typename Vector>
  TEGATA_KERNEL static void store(const Vector& rows, double* first) {
    std::memcpy(first, &rows, sizeof rows);
  }

  TEGATA_KERNEL double* place(Eigen::Index row, Eigen::Index column) {
    return values_.data() + column * kStride + row;
  }
  TEGATA_KERNEL const double* place(Eigen::Index row, Eigen::Index column) const {
    return values_.data() + column * kStride + row;
  }

  TEGATA_KERNEL double invert_pivot(Eigen::Index k) {
    const double pivot = *place(k, k);
    return inverse_pivots_[k] = pivot > 0.0 ? 1.0 / pivot : 0.0;
  }

  // Takes one column or two that follow each other from column j. Above its diagonal that keeps how
  // often, for substitute_back().
  template <Eigen::Index kCount>
  TEGATA_KERNEL void take(Eigen::Index k, double inverse, Eigen::Index j) {
    const double factor = *place(k, j) = *place(j, k) * inverse;
    for (Eigen::Index i = j; i < rows_; i += kCount) {
      RowVector<kCount> rows, of_k;
      load(place(i, j), rows);
      load(place(i, k), of_k);
      rows -= factor * of_k;
      store(rows, place(i, j));
    }
  }
  template <Eigen::Index kCount>
  TEGATA_KERNEL void take_two(Eigen::Index k, double inverse, double next_inverse, Eigen::Index j) {
    const double factor = *place(k, j) = *place(j, k) * inverse;
    const double next = *place(k + 1, j) = *place(j, k + 1) * next_inverse;
    for (Eigen::Index i = j; i < rows_; i += kCount) {
      RowVector<kCount> rows, of_k, of_next;
      load(place(i, j), rows);
      load(place(i, k), of_k);
      load(place(i, k + 1), of_next);
      rows -= factor * of_k + next * of_next;
      store(rows, place(i, j));
    }
  }

  // Each pair of columns is taken from all after it at once: a sum over all before a column would
  // keep its pivot waiting.
  template <Eigen::Index kCount>
  TEGATA_KERNEL static void eliminate_by(ColumnElimination& all, Eigen::Index count) {
    all.count_ = count;
    Eigen::Index k = 0;
    for (; k + 1 < count; k += 2) {
      const double inverse = all.invert_pivot(k);
      all.template take<kCount>(k, inverse, k + 1);
      const double next_inverse = all.invert_pivot(k + 1);
      for (Eigen::Index j = k + 2; j < count; ++j) {
        all.template take_two<kCount>(k, inverse, next_inverse, j);
      }
    }
    if (k < count) all.invert_pivot(k);
  }
  static void eliminate_baseline(ColumnElimination& all, Eigen::Index count) {
    eliminate_by<kLanes>(all, count);
  }
  TEGATA_AVX2 static void eliminate_avx2(ColumnElimination& all, Eigen::Index count) {
    eliminate_by<4>(all, count);
  }
  TEGATA_AVX512 static void eliminate_avx512(ColumnElimination& all, Eigen::Index count) {
    eliminate_by<kMostLanes>(all, count);
  }

  template <Eigen::Index kCount, typename Left>
  TEGATA_KERNEL static void subtract_by(const ColumnElimination& all, Left& left,
                                        Eigen::Index count, Eigen::Index row) {
    for (Eigen::Index j = 0; j < count; ++j) {
      double factors[kMostColumns];
      for (Eigen::Index k = 0; k < all.count_; ++k) {
        factors[k] = *all.place(row + j, k) * all.inverse_pivots_[k];
      }
      for (Eigen::Index i = row + j; i < all.rows_; i += kCount) {
        RowVector<kCount> rows, of_k, of_next;
        load(left.place(i - row, j), rows);
        Eigen::Index k = 0;
        for (; k + 1 < all.count_; k += 2) {  // by twos, as each difference waits for the last
          load(all.place(i, k), of_k);
          load(all.place(i, k + 1), of_next);
          rows -= factors[k] * of_k + factors[k + 1] * of_next;
        }
        if (k < all.count_) {
          load(all.place(i, k), of_k);
          rows -= factors[k] * of_k;
        }
        store(rows, left.place(i - row, j));
      }
    }
  }
  template <typename Left>
  static void subtract_baseline(const ColumnElimination& all, Left& left, Eigen::Index count,
                                Eigen::Index row) {
    subtract_by<kLanes>(all, left, count, row);
  }
  template <typename Left>
  TEGATA_AVX2 static void subtract_avx2(const ColumnElimination& all, Left& left,
                                        Eigen::Index count, Eigen::Index row) {
    subtract_by<4>(all, left, count, row);
  }
  template <typename Left>
  TEGATA_AVX512 static void subtract_avx512(const ColumnElimination& all, Left& left,
                                            Eigen::Index count, Eigen::Index row) {
    subtract_by<kMostLanes>(all, left, count, row);
  }

  static constexpr Eigen::Index kStride = kMostRows + kMostLanes - 1;  // with room for the lanes

  Eigen::Index rows_, count_ = 0;
  InstructionSet set_;
  Eigen::Matrix<double, kStride, kMostColumns> values_;
  Eigen::Matrix<double, kMostColumns, 1> inverse_pivots_;
};

}  // namespace tegata
