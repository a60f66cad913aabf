// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/hull_term.h"

#include "tegata/base/error.h"
#include "tegata/fit/surface_pairs.h"
#include "tegata/fit/surface_row.h"
#include "tegata/hand/posed_rows.h"
#include "tegata/math/robust_kernel.h"

namespace tegata {
namespace {

std::vector<Eigen::Vector3d> proven_vertices(const TriangleMesh& hull,
                                             std::vector<Eigen::Vector3d>& normals,
                                             std::vector<Eigen::Vector3d>& unproven) {
  if (hull.normals.size() != hull.vertices.size()) {
    throw Error("hull: got ", hull.normals.size(), " normals for ", hull.vertices.size(),
                " vertices, expected one each");
  }
  std::vector<Eigen::Vector3d> vertices;
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    if (!hull.unproven.empty() && hull.unproven[i] != 0) {
      unproven.push_back(hull.vertices[i]);
      continue;
    }
    vertices.push_back(hull.vertices[i]);
    normals.push_back(hull.normals[i]);
  }
  if (vertices.empty()) throw Error("hull: no vertex is proven by the silhouettes");
  return vertices;
}

// Pairs of points, each with the normal of the one that was found as the closest.
class PairSum {
 public:
  PairSum(const PosedHand& posed, const HullTermOptions& options, std::size_t count, double scale)
      : posed_(posed),
        sigma_(options.sigma * scale),
        kernel_(sigma_),
        // The mean over the points, not their number, has a weight: a finer mesh knows no more.
        precision_(options.weight /
                   (static_cast<double>(count) * square(options.standard_deviation * scale))) {
    pairs_.reserve(count);
  }

  void add(std::uint32_t hand_vertex, const Eigen::Vector3d& hull_point,
           const Eigen::Vector3d& normal) {
    const double distance = (posed_.vertices()[hand_vertex] - hull_point).norm();
    pairs_.push_back({hand_vertex, hull_point, normal, precision_ * kernel_.weight(distance)});
    cost_ += precision_ * kernel_.cost(distance);
  }
  // A pair without a meaning costs what one at sigma costs, so that nothing is won by losing pairs.
  void add_unmatched() { cost_ += precision_ * kernel_.cost(sigma_); }

  void add_to(FrameEquations& equations, const ShapeMotion* shape) const {
    const PosedRows& rows = posed_.rows();
    SurfacePairs(rows.rows(), pairs_).add_to(equations, rows.motion());
    equations.cost += cost_;
    if (shape == nullptr) return;
    for (const SurfacePair& pair : pairs_) {
      HandRow row;
      add_vertex_row(posed_, pair.vertex, pair.normal, row);
      const double residual = pair.normal.dot(posed_.vertices()[pair.vertex] - pair.point);
      equations.add_shape(residual, row, pair.weight,
                          shape->row(pair.vertex, pair.normal.transpose()));
    }
  }

 private:
  static double square(double x) { return x * x; }

  const PosedHand& posed_;
  double sigma_;
  LorentzianKernel kernel_;
  double precision_;
  std::vector<SurfacePair> pairs_;
  double cost_ = 0.0;
};

}  // namespace

HullTarget::HullTarget(const TriangleMesh& hull)
    : nearest(proven_vertices(hull, normals, unproven)) {
  constexpr std::size_t kMostSamples = 600;
  const std::size_t count = nearest.points().size();
  for (std::size_t i = 0; i < count; i += 1 + count / kMostSamples) {
    samples.push_back(static_cast<std::uint32_t>(i));
  }
}

void add_hull_term(const FitHand& hand, const PosedHand& posed, const HullTarget& hull,
                   const HullTermOptions& options, FrameEquations& equations,
                   const ShapeMotion* shape) {
  const std::vector<Eigen::Vector3d>& vertices = posed.vertices();
  const std::vector<Eigen::Vector3d>& hull_vertices = hull.nearest.points();

  PairSum towards_hull(posed, options, hand.samples.size(), hand.scale);
  for (const std::uint32_t i : hand.samples) {
    const std::uint32_t match = hull.nearest.nearest(vertices[i]).index;
    if (posed.normals()[i].dot(hull.normals[match]) <= 0.0) {
      towards_hull.add_unmatched();
    } else {
      towards_hull.add(i, hull_vertices[match], hull.normals[match]);
    }
  }
  towards_hull.add_to(equations, shape);

  const NearestPoint nearest_vertex(vertices);
  PairSum towards_hand(posed, options, hull.samples.size(), hand.scale);
  for (const std::uint32_t i : hull.samples) {
    const std::uint32_t match = nearest_vertex.nearest(hull_vertices[i]).index;
    const Eigen::Vector3d& normal = posed.normals()[match];
    if (hand.beyond_wrist[match] == 0 || normal.dot(hull.normals[i]) <= 0.0) {
      towards_hand.add_unmatched();
    } else {
      towards_hand.add(match, hull_vertices[i], normal);
    }
  }
  towards_hand.add_to(equations, shape);
}

}  // namespace tegata
