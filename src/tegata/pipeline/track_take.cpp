// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/track_take.h"

#include <string>
#include <utility>

#include "tegata/base/error.h"
#include "tegata/base/stopwatch.h"
#include "tegata/pipeline/check_calibration.h"
#include "tegata/pipeline/describe_frame.h"
#include "tegata/pipeline/in_world.h"

namespace tegata {
namespace {

// What comes of the frames, one after the other.
class TrackedTake {
 public:
  TrackedTake(const FitHand& hand, const SceneFrame& scene, const TrackTakeOptions& options,
              const Observer& observer)
      : hand_(hand),
        scene_(scene),
        options_(options),
        observer_(observer),
        tracker_(hand, options.track) {}

  void add(PreparedFrame frame) {
    for (const std::string& note : frame.notes) observer_.warn(note);
    segment_seconds_ += frame.segment_seconds;
    if (frame.refusal.empty()) {
      track(frame);
    } else {
      observer_.warn(text("frame ", frame.name, ": ", frame.refusal));
      frames_.push_back(describe_missing(frame, frame.refusal));
    }
  }

  Result result() && {
    Result result;
    result.grasp_angles = tracked_.angles;
    result.grasp_standard_deviations = tracked_.standard_deviations;
    result.frames = std::move(frames_);
    result.iterations = static_cast<int>(pose_count_);
    result.termination = tracker_.is_lost() ? "lost" : "followed to the end";
    result.seconds = {
        {"segment", segment_seconds_}, {"hull", hull_seconds_}, {"frames", track_seconds_}};
    return in_world(scene_, std::move(result));
  }
  std::size_t pose_count() const { return pose_count_; }

 private:
  void track(PreparedFrame& frame) {
    const bool was_lost = tracker_.is_lost();
    if (was_lost) make_hull(frame);
    tracked_ = follow(frame);
    if (tracked_.state == TrackState::lost && !was_lost) {
      make_hull(frame);
      tracked_ = follow(frame);
    }
    if (tracked_.state == TrackState::lost) {
      if (!was_lost || pose_count_ == 0)
        observer_.warn(text("frame ", frame.name, ": no hand found"));
      frames_.push_back(describe_missing(frame, "the hand is lost"));
      return;
    }
    if (tracked_.state == TrackState::found && pose_count_ > 0) {
      observer_.warn(text("frame ", frame.name, ": the hand was lost and is found again"));
    }
    ++pose_count_;
    frames_.push_back(describe_frame(hand_, tracked_.pose, frame));
  }

  TrackedFrame follow(const PreparedFrame& frame) {
    const Stopwatch watch;
    const TrackedFrame tracked = tracker_.next(frame.frame);
    track_seconds_ += watch.seconds();
    return tracked;
  }

  void make_hull(PreparedFrame& frame) {
    add_hull(frame, in_scene(options_.hull, scene_));
    hull_seconds_ += frame.hull_seconds;
    if (!frame.refusal.empty()) {
      observer_.warn(text("frame ", frame.name, ": ", frame.refusal));
    } else if (options_.on_hull) {
      options_.on_hull(frame.name, in_world(scene_, frame.hull));
    }
  }

  const FitHand& hand_;
  const SceneFrame& scene_;
  const TrackTakeOptions& options_;
  const Observer& observer_;
  HandTracker tracker_;
  TrackedFrame tracked_;
  std::vector<ResultFrame> frames_;
  std::size_t pose_count_ = 0;
  double segment_seconds_ = 0.0, hull_seconds_ = 0.0, track_seconds_ = 0.0;
};

}  // namespace

Result track_take(Take& take, const HandModel& hand_model, const TrackTakeOptions& options,
                  const Observer& observer) {
  check_hand(hand_model);
  refuse_bad_numbers(take);
  const FitHand hand(hand_model);
  const std::vector<std::size_t> indices = selected_frames(options.frames, take);
  const SceneFrame scene = scene_of(take, options);
  const Segmenter segmenter(take, options.segmentation, observer, scene);
  TrackedTake tracked(hand, scene, options, observer);
  std::vector<PreparedFrame> ahead(kFramesAtOnce);
  for_each_frame(take, indices, options.threads,
                 {.work =
                      [&](std::size_t i, const TakeFrame& pictures) {
                        ahead[i % kFramesAtOnce] = prepare_views(segmenter, pictures);
                      },
                  .finish =
                      [&](std::size_t i) {
                        PreparedFrame frame = std::exchange(ahead[i % kFramesAtOnce], {});
                        if (i == 0) {
                          frame.frame.landmarks =
                              start_landmarks(take, scene, indices[0] == 0, observer);
                        }
                        tracked.add(std::move(frame));
                      }},
                 observer);
  if (tracked.pose_count() == 0) {
    throw Error(take.folder().string(), ": the hand was found in none of ", indices.size(),
                " frames; `tegata calibration check` or `tegata segment` may tell why");
  }
  Result result = std::move(tracked).result();
  result.take = take.info().name;
  result.side = hand_model.skeleton.side;
  result.model_name = hand_model.name;
  result.model_scale = options.scale.value_or(1.0);
  return result;
}

}  // namespace tegata
