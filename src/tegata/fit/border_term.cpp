// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/border_term.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "tegata/fit/outline_piece.h"
#include "tegata/image/distance_transform.h"
#include "tegata/math/robust_kernel.h"

namespace tegata {
namespace {

// Two distances agree on which border is the nearest one.
constexpr float kAgreementPx = 0.25F;
// Of two normals: with a smaller product they face apart, with a larger one they face the same way.
constexpr double kApart = 0.3, kSameWay = 0.7;
// So far away seems what faces another way, for a difference of one from kSameWay.
constexpr double kTurnedAwayPx = 20.0;
// How far beside a border what hides the hand is looked for.
constexpr double kLookBesidePx = 3.0;

double share_facing(double product) {
  const double u = std::clamp((product - kApart) / (kSameWay - kApart), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

double depth_of(const OutlinePiece& piece, const FitView& view) {
  return (view.camera.camera_from_world * piece.point).z();
}

bool is_behind(const OutlinePiece& piece, const Eigen::Vector2d& pixel, const FitView& view) {
  return view.hiding_depth && view.is_hidden(pixel, depth_of(piece, view));
}

// What is asked of the pieces, summed up for each as the normal equations of its pixel.
class PieceSum {
 public:
  PieceSum(const std::vector<OutlinePiece>& pieces, const FitView& view,
           const BorderTermOptions& options, double scale)
      : pieces_(pieces),
        view_(view),
        kernels_{LorentzianKernel(options.sigma * scale),
                 LorentzianKernel(options.violation_sigma * scale)},
        precision_(options.weight /
                   (options.standard_deviation * options.standard_deviation * scale * scale)),
        unmatched_cost_(kernels_[0].cost(options.sigma * scale)),
        asked_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      asked_[i].metres_per_px = depth_of(pieces[i], view) / view.camera.fx;
    }
  }

  // The residuals that follow have so much weight in all: their mean counts.
  void begin(double weight) { share_ = precision_ / weight; }
  // `gap_px` is the residual, `direction` its gradient by the piece's pixel, `distance_px` what the
  // kernel is asked about.
  void add(std::size_t i, double gap_px, const Eigen::Vector2d& direction, double distance_px,
           bool is_violation, double weight) {
    Asked& asked = asked_[i];
    const LorentzianKernel& kernel = kernels_[is_violation ? 1 : 0];
    const double distance = distance_px * asked.metres_per_px;
    const Eigen::Vector2d weighted = weight * share_ * kernel.weight(distance) * direction;
    asked.information += weighted * direction.transpose();
    asked.gradient += gap_px * weighted;
    cost_ += weight * share_ * kernel.cost(distance);
  }
  // As the contour term has it.
  void add_without_counterpart(double weight) { cost_ += weight * share_ * unmatched_cost_; }

  void add_to(FrameEquations& equations, const PosedHand& posed) const {
    equations.cost += cost_;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Asked& asked = asked_[i];
      // L D L^T of the 2 x 2 sum, the larger entry first.
      const int first = asked.information(1, 1) > asked.information(0, 0) ? 1 : 0;
      const double larger = asked.information(first, first);
      if (!(larger > 0.0)) continue;
      const double factor = asked.information(0, 1) / larger;
      const double smaller = asked.information(1 - first, 1 - first) - factor * factor * larger;
      Eigen::Vector2d direction = Eigen::Vector2d::Unit(1 - first);
      if (smaller > 1e-12 * larger) {
        const double rest = asked.gradient[1 - first] - factor * asked.gradient[first];
        add_row(i, direction, smaller, rest / smaller, equations, posed);
      }
      direction *= factor;
      direction[first] = 1.0;
      add_row(i, direction, larger, asked.gradient[first] / larger, equations, posed);
    }
  }

 private:
  struct Asked {
    double metres_per_px = 0.0;
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  // sum of w d d^T
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();     // sum of w gap d
  };

  void add_row(std::size_t i, const Eigen::Vector2d& direction, double weight, double gap_px,
               FrameEquations& equations, const PosedHand& posed) const {
    const double metres_per_px = asked_[i].metres_per_px;
    const Eigen::RowVector3d along =
        metres_per_px * direction.transpose() * project_jacobian(view_.camera, pieces_[i].point);
    equations.add(gap_px * metres_per_px, outline_row(posed, pieces_[i], along), weight, 0.0);
  }

  const std::vector<OutlinePiece>& pieces_;
  const FitView& view_;
  LorentzianKernel kernels_[2];
  double precision_, unmatched_cost_, share_ = 0.0, cost_ = 0.0;
  std::vector<Asked> asked_;
};

// Pieces against the distance to the silhouette's border. Positive gap: hand pixels lie outside the
// outline.
void add_pieces_to_silhouette(const std::vector<OutlinePiece>& pieces, const FitView& view,
                              PieceSum& sum) {
  double length = 0.0;
  for (const OutlinePiece& piece : pieces) length += piece.weight_px;
  sum.begin(length);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const OutlinePiece& piece = pieces[i];
    if (!piece.beyond_wrist || view.is_forearm(piece.pixel)) continue;
    const double x = piece.pixel.x(), y = piece.pixel.y();
    const Image<float>& distance = *view.hand_distance;
    const float gap = sample_bilinear(distance, x, y);
    if (gap < 0.0F && is_behind(piece, piece.pixel, view)) continue;
    if (std::abs(gap - sample_bilinear(*view.possible_distance, x, y)) > kAgreementPx) continue;
    const Eigen::Vector2d gradient(
        0.5 * (sample_bilinear(distance, x + 1.0, y) - sample_bilinear(distance, x - 1.0, y)),
        0.5 * (sample_bilinear(distance, x, y + 1.0) - sample_bilinear(distance, x, y - 1.0)));
    // The distance falls outwards; a border that faces another way is another finger's.
    const double facing = share_facing(-gradient.dot(piece.normal));
    if (facing < 1.0) sum.add_without_counterpart((1.0 - facing) * piece.weight_px);
    if (facing > 0.0) {
      sum.add(i, gap, gradient, std::abs(gap), gap > 0.0F, facing * piece.weight_px);
    }
  }
}

struct NearestPiece {
  const OutlinePiece* piece = nullptr;
  double across_px = 0.0;  // from the contour point along the piece's normal
  double squared = std::numeric_limits<double>::infinity();
};

// The piece that is nearest if what faces another way counts as farther away. Pieces are sorted by
// x: the search goes from the contour point's x to either side.
NearestPiece nearest_piece(const std::vector<OutlinePiece>& pieces,
                           const ContourPoint& contour_point) {
  NearestPiece best;
  // False where this piece and those beyond it are farther away than the best one.
  const auto consider = [&](const OutlinePiece& piece) {
    const Eigen::Vector2d difference = piece.pixel - contour_point.pixel;
    // A piece's end may be nearer than its middle.
    const double beside = std::max(0.0, std::abs(difference.x()) - 1.0);
    if (beside * beside > best.squared) return false;
    const double product = piece.normal.dot(contour_point.normal);
    if (product <= 0.0) return true;
    const double across = piece.normal.dot(difference);
    const double sideways =
        std::abs(piece.normal.x() * difference.y() - piece.normal.y() * difference.x());
    const double along = std::max(0.0, sideways - 0.5 * piece.length_px);
    const double turned = kTurnedAwayPx * std::max(0.0, kSameWay - product);
    const double squared = across * across + along * along + turned * turned;
    if (squared < best.squared) best = {&piece, across, squared};
    return true;
  };
  const auto middle =
      std::lower_bound(pieces.begin(), pieces.end(), contour_point.pixel.x(),
                       [](const OutlinePiece& piece, double x) { return piece.pixel.x() < x; });
  auto right = middle;
  auto left = std::make_reverse_iterator(middle);
  bool goes_right = true, goes_left = true;
  while (goes_right || goes_left) {
    goes_right = goes_right && right != pieces.end() && consider(*right++);
    goes_left = goes_left && left != pieces.rend() && consider(*left++);
  }
  return best;
}

// Contour points of the silhouette against the nearest piece.
void add_silhouette_to_pieces(const std::vector<OutlinePiece>& pieces, const HandPicture& drawn,
                              const FitView& view, PieceSum& sum) {
  sum.begin(static_cast<double>(view.contour.size()));
  for (const ContourPoint& contour_point : view.contour) {
    if (view.is_forearm(contour_point.pixel)) continue;
    const NearestPiece nearest = nearest_piece(pieces, contour_point);
    const OutlinePiece* piece = nearest.piece;
    if (piece == nullptr || !piece->beyond_wrist) {
      sum.add_without_counterpart(1.0);
      continue;
    }
    // Where the hand goes on behind something, its border is that one's.
    const Eigen::Vector2d beside = contour_point.pixel + kLookBesidePx * contour_point.normal;
    if (is_behind(*piece, beside, view)) continue;
    // A piece far away may face any way: what the model covers is no violation.
    const bool is_violation = nearest.across_px < 0.0 && drawn.cover(contour_point.pixel) <= 0.5;
    sum.add(static_cast<std::size_t>(piece - pieces.data()), nearest.across_px, piece->normal,
            std::sqrt(nearest.squared), is_violation, 1.0);
  }
}

}  // namespace

void add_border_term(const FitHand& hand, const PosedHand& posed, const FitView& view,
                     const BorderTermOptions& options, FrameEquations& equations) {
  const HandPicture drawn(posed, view.camera);
  const std::vector<OutlinePiece> pieces = outline_pieces(hand, posed, view.camera, drawn);
  if (pieces.empty() || view.contour.empty()) return;
  PieceSum sum(pieces, view, options, hand.scale);
  add_pieces_to_silhouette(pieces, view, sum);
  add_silhouette_to_pieces(pieces, drawn, view, sum);
  sum.add_to(equations, posed);
}

}  // namespace tegata
