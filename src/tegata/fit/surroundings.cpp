// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/fit/surroundings.h"

#include <memory>
#include <optional>

#include "tegata/base/parallel.h"
#include "tegata/fit/forearm.h"
#include "tegata/fit/forearm_picture.h"
#include "tegata/image/rasterizer.h"

namespace tegata {

std::vector<FitFrame> with_surroundings(const FitHand& hand,
                                        std::span<const FitFrame* const> frames,
                                        const HandEstimate& estimate, const TriangleMesh& object,
                                        int threads) {
  std::vector<FitFrame> result;
  for (const FitFrame* frame : frames) result.push_back(*frame);
  parallel_for(frames.size(), threads, [&](std::size_t f) {
    const Rigid3d& world_from_hand = estimate.world_from_hand[f];
    const std::optional<Forearm> forearm = find_forearm(hand, *frames[f], world_from_hand);
    const PosedHand posed = hand.posed(estimate.pose(f));
    TriangleMesh object_in_world = object;
    for (Eigen::Vector3d& vertex : object_in_world.vertices) vertex = world_from_hand * vertex;
    for (FitView& view : result[f].views) {
      if (forearm) {
        view.forearm = std::make_shared<const Silhouette>(
            forearm_picture(hand, posed, *frames[f], view.camera, *forearm));
      }
      if (!object.triangles.empty()) {
        view.hiding_depth =
            std::make_shared<const Image<float>>(render(object_in_world, view.camera).depth);
      }
    }
  });
  return result;
}

std::vector<const FitFrame*> pointers_to(const std::vector<FitFrame>& frames) {
  std::vector<const FitFrame*> pointers;
  for (const FitFrame& frame : frames) pointers.push_back(&frame);
  return pointers;
}

}  // namespace tegata
