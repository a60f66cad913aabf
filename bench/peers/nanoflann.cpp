// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <nanoflann.hpp>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

struct Cloud {
  const std::vector<double>& points;

  std::size_t kdtree_get_point_count() const { return points.size() / 3; }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const {
    return points[3 * point + axis];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

}  // namespace

std::string nanoflann_version() {
  constexpr unsigned kVersion = NANOFLANN_VERSION;  // one hexadecimal digit each
  return std::to_string(kVersion >> 8) + "." + std::to_string(kVersion >> 4 & 15u) + "." +
         std::to_string(kVersion & 15u);
}

void nanoflann_nearest(const std::vector<double>& points, const std::vector<double>& queries,
                       std::vector<std::uint32_t>& nearest) {
  const Cloud cloud{points};
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                   Cloud, 3, std::uint32_t>;
  const Tree tree(3, cloud);
  nearest.resize(queries.size() / 3);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    double squared_distance = 0.0;
    tree.knnSearch(&queries[3 * i], 1, &nearest[i], &squared_distance);
  }
}

}  // namespace tegata::bench
