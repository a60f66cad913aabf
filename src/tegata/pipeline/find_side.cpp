// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/find_side.h"

#include "tegata/base/error.h"
#include "tegata/fit/frame_fit.h"
#include "tegata/fit/start.h"

namespace tegata {
namespace {

constexpr std::size_t kTrialFrames = 4;

double energy_of(const FitHand& hand, const FitFrame& frame, int threads) {
  return fit_frame_from_nothing(hand, frame, typical_angles(), search_schedules(), threads)
      .report.energy;
}

}  // namespace

SideChoice find_side(Take& take, const HandModel& right, const HandModel& left,
                     const PrepareOptions& options, const Observer& observer) {
  const SceneFrame scene = scene_of(take, options);
  const Segmenter segmenter(take, options.segmentation, observer, scene);
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const FitHand right_hand(right), left_hand(left);
  double right_energy = 0.0, left_energy = 0.0;
  std::string refusal;
  for (const std::size_t i : spread(indices.size(), kTrialFrames)) {
    // Without an observer: what there is to say of a frame is said when it is fitted.
    PreparedFrame frame = prepare_frame(segmenter, take.read_frame(indices[i], Observer{}),
                                        in_scene(options.hull, scene));
    if (!frame.refusal.empty()) {
      refusal = text("frame ", frame.name, ": ", frame.refusal);
      continue;
    }
    right_energy += energy_of(right_hand, frame.frame, options.threads);
    left_energy += energy_of(left_hand, frame.frame, options.threads);
  }
  if (right_energy == 0.0 && left_energy == 0.0) {
    throw Error(take.folder().string(), ": no frame tells which hand it shows; ", refusal,
                "; --side right or left spares the search");
  }
  const bool is_right = right_energy <= left_energy;
  const double winner = is_right ? right_energy : left_energy;
  return {is_right ? Side::right : Side::left, (right_energy + left_energy - winner) / winner};
}

}  // namespace tegata
