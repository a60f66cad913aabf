// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/border_term.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tegata/fit/outline_piece.h"
#include "tegata/fit/outline_sum.h"
#include "tegata/image/distance_transform.h"

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

// Pieces against the distance to the silhouette's border. Positive gap: hand pixels lie outside the
// outline.
void add_pieces_to_silhouette(const std::vector<OutlinePiece>& pieces, const FitView& view,
                              OutlineSum& sum) {
  double length = 0.0;
  for (const OutlinePiece& piece : pieces) length += piece.weight_px;
  sum.begin(length);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const OutlinePiece& piece = pieces[i];
    if (!piece.beyond_wrist || view.is_forearm(piece.pixel)) continue;
    const double x = piece.pixel.x(), y = piece.pixel.y();
    const float gap = sample_bilinear(*view.hand_distance, x, y);
    if (gap < 0.0F && is_hidden_there(view, piece.point, piece.pixel)) continue;
    if (std::abs(gap - sample_bilinear(*view.possible_distance, x, y)) > kAgreementPx) continue;
    const Eigen::Vector2d gradient = distance_gradient(view, piece.pixel);
    // The distance falls outwards; a border that faces another way is another finger's.
    const double facing = share_facing(-gradient.dot(piece.normal));
    if (facing < 1.0) sum.add_unmatched((1.0 - facing) * piece.weight_px);
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
  visit_from(pieces, contour_point.pixel.x(), consider);
  return best;
}

// Contour points of the silhouette against the nearest piece.
void add_silhouette_to_pieces(const std::vector<OutlinePiece>& pieces, const HandPicture& drawn,
                              const FitView& view, OutlineSum& sum) {
  sum.begin(static_cast<double>(view.contour.size()));
  for (const ContourPoint& contour_point : view.contour) {
    if (view.is_forearm(contour_point.pixel)) continue;
    const NearestPiece nearest = nearest_piece(pieces, contour_point);
    const OutlinePiece* piece = nearest.piece;
    if (piece == nullptr || !piece->beyond_wrist) {
      sum.add_unmatched(1.0);
      continue;
    }
    // Where the hand goes on behind something, its border is that one's.
    const Eigen::Vector2d beside = contour_point.pixel + kLookBesidePx * contour_point.normal;
    if (is_hidden_there(view, piece->point, beside)) continue;
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
  OutlineSum sum(
      metres_per_px(pieces, view.camera),
      {options.sigma, options.violation_sigma, options.standard_deviation, options.weight},
      hand.scale);
  add_pieces_to_silhouette(pieces, view, sum);
  add_silhouette_to_pieces(pieces, drawn, view, sum);
  equations.cost += sum.cost();
  sum.for_each_row([&](std::size_t i, const Eigen::RowVector2d& metres_along, double weight,
                       double gap) {
    const Eigen::RowVector3d along = metres_along * project_jacobian(view.camera, pieces[i].point);
    equations.add(gap, outline_row(posed, pieces[i], along), weight, 0.0);
  });
}

}  // namespace tegata
