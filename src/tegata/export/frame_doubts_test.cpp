// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/frame_doubts.h"

#include <gtest/gtest.h>

#include "tegata/base/text.h"

namespace tegata {
namespace {

/// A hand that moves evenly before three cameras.
Result even_result(std::size_t frame_count) {
  Result result;
  for (std::size_t i = 0; i < frame_count; ++i) {
    ResultFrame frame;
    frame.name = text("frame", i);
    frame.pose.emplace().world_from_hand.translation.x() = 0.02 * static_cast<double>(i);
    frame.views = {"a", "b", "c"};
    const double wobble = 0.02 * static_cast<double>(i % 3);
    frame.silhouette_iou = {{"a", 0.9 - wobble}, {"b", 0.8 + wobble}, {"c", 0.95}};
    result.frames.push_back(frame);
  }
  return result;
}

std::string only_reason(const FrameDoubt& doubt) {
  return doubt.reasons.size() == 1 ? doubt.reasons.front() : text(doubt.reasons.size(), " reasons");
}

TEST(FrameDoubts, EvenResultIsTrusted) {
  const Result result = even_result(12);
  const auto doubts = frame_doubts(result);
  for (const FrameDoubt& doubt : doubts) EXPECT_TRUE(doubt.reasons.empty()) << doubt.frame;
  EXPECT_EQ(fit_verdict(result, doubts).word, "good");
  EXPECT_EQ(fit_verdict(result, doubts).sentence, "12 of 12 frames can be trusted.");
}

TEST(FrameDoubts, OneBrokenCameraIsNamed) {
  Result result = even_result(12);
  result.frames[7].silhouette_iou["b"] = 0.55;
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(worst_frame(doubts), 7u);
  EXPECT_EQ(only_reason(doubts[7]), "overlap in b 0.55, around it 0.82");
  EXPECT_TRUE(doubts[6].reasons.empty() && doubts[8].reasons.empty());
  EXPECT_EQ(fit_verdict(result, doubts).trusted, 11u);
}

TEST(FrameDoubts, ObjectThatSlowlyHidesHalfOfTheHandIsNoDoubt) {
  Result result = even_result(40);
  for (std::size_t i = 0; i < 40; ++i) {
    result.frames[i].silhouette_iou["a"] = 0.97 - 0.011 * static_cast<double>(i);
  }
  EXPECT_EQ(fit_verdict(result, frame_doubts(result)).trusted, 40u);
  for (const std::size_t broken : {30u, 31u, 32u}) result.frames[broken].silhouette_iou["a"] = 0.44;
  result.frames[10].silhouette_iou["a"] = 0.6;
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(fit_verdict(result, doubts).trusted, 36u);
  EXPECT_EQ(only_reason(doubts[10]), "overlap in a 0.60, around it 0.85");
}

TEST(FrameDoubts, CameraThatIsAlwaysWrongIsNotUsual) {
  Result result = even_result(6);
  for (ResultFrame& frame : result.frames) frame.silhouette_iou["b"] = 0.3;
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(only_reason(doubts[2]), "overlap in b only 0.30");
  EXPECT_EQ(fit_verdict(result, doubts).word, "poor");
}

TEST(FrameDoubts, HandThatSomethingHidesIsTrustedWhileAllThatIsSeenIsCovered) {
  Result result = even_result(6);
  for (ResultFrame& frame : result.frames) {
    frame.silhouette_iou["b"] = 0.4;
    frame.uncovered = {{"a", 0.0}, {"b", 1e-4}, {"c", 2e-4}};
  }
  EXPECT_EQ(fit_verdict(result, frame_doubts(result)).trusted, 6u);
  for (ResultFrame& frame : result.frames) frame.silhouette_iou["b"] = 0.2;
  EXPECT_EQ(only_reason(frame_doubts(result)[2]), "overlap in b only 0.20");
}

TEST(FrameDoubts, WrongPoseWithAFairOverlapIsNotTrusted) {
  Result result = even_result(6);
  for (ResultFrame& frame : result.frames) frame.uncovered = {{"a", 1e-4}, {"c", 2e-4}};
  result.frames[3].uncovered["c"] = 0.0025;
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(only_reason(doubts[3]), "the hand in c reaches 2.5 mm beyond the fitted one");
  EXPECT_TRUE(doubts[2].reasons.empty());
}

TEST(FrameDoubts, HandThatFitsNoFrameIsSaidOfTheWhole) {
  Result result = even_result(6);
  for (ResultFrame& frame : result.frames) frame.uncovered = {{"a", 3e-4}, {"c", 0.0025}};
  const FitVerdict verdict = fit_verdict(result, frame_doubts(result));
  EXPECT_EQ(verdict.word, "fair");
  EXPECT_EQ(verdict.trusted, 6u);
  EXPECT_NE(verdict.sentence.find("2.5 mm beyond"), std::string::npos) << verdict.sentence;
}

TEST(FrameDoubts, CameraThatWasLeftOutIsNamedWithTheReason) {
  Result result = even_result(12);
  for (const std::size_t broken : {3u, 5u, 7u}) result.frames[broken].left_out["b"] = "it is dark";
  const auto doubts = frame_doubts(result);
  EXPECT_TRUE(doubts[5].reasons.empty());
  EXPECT_EQ(worst_frame(doubts), 3u);
  EXPECT_EQ(fit_verdict(result, doubts).sentence,
            "12 of 12 frames can be trusted. b was left out of 3: it is dark.");
}

TEST(FrameDoubts, JumpAndMissingViewsAreSaid) {
  Result result = even_result(12);
  result.frames[4].pose->world_from_hand.translation.y() = 0.08;
  result.frames[9].views = {"a", "c"};
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(only_reason(doubts[4]), "the wrist jumps by 80 mm");
  EXPECT_TRUE(doubts[3].reasons.empty() && doubts[5].reasons.empty());
  EXPECT_EQ(only_reason(doubts[9]), "seen by 2 cameras only");
}

TEST(FrameDoubts, HandOfAnotherScaleIsDoubtedForTheSameReasons) {
  Result result = even_result(12);
  for (ResultFrame& frame : result.frames) frame.uncovered = {{"a", 0.0004}, {"b", 0.0003}};
  result.frames[4].uncovered["b"] = 0.009;
  Result large = result;
  large.model_scale = 10.0;
  for (ResultFrame& frame : large.frames) {
    frame.pose->world_from_hand.translation *= 10.0;
    for (auto& [camera, distance] : frame.uncovered) distance *= 10.0;
  }
  const auto doubts = frame_doubts(result), of_large = frame_doubts(large);
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    EXPECT_EQ(doubts[i].reasons.size(), of_large[i].reasons.size()) << i;
    EXPECT_NEAR(doubts[i].severity, of_large[i].severity, 1e-12) << i;
  }
  EXPECT_EQ(only_reason(of_large[4]), "the hand in b reaches 90.0 mm beyond the fitted one");
  EXPECT_EQ(fit_verdict(large, of_large).word, fit_verdict(result, doubts).word);
}

TEST(FrameDoubts, WrongPoseIsWorseThanNone) {
  Result result = even_result(5);
  result.frames[3].pose.reset();
  result.frames[3].silhouette_iou.clear();
  result.frames[3].status = "no hand found";
  const auto doubts = frame_doubts(result);
  EXPECT_EQ(worst_frame(doubts), 3u);
  EXPECT_EQ(only_reason(doubts[3]), "no hand found");
  result.frames[1].silhouette_iou["a"] = 0.3;
  EXPECT_EQ(worst_frame(frame_doubts(result)), 1u);
}

TEST(FrameDoubts, ResultWithoutFramesOrPosesHasAVerdict) {
  Result result = even_result(1);
  EXPECT_EQ(fit_verdict(result, frame_doubts(result)).word, "good");
  result.frames[0] = ResultFrame{};
  EXPECT_EQ(fit_verdict(result, frame_doubts(result)).word, "poor");
  result.frames.clear();
  EXPECT_EQ(worst_frame(frame_doubts(result)), 0u);
  EXPECT_EQ(fit_verdict(result, {}).word, "poor");
}

}  // namespace
}  // namespace tegata
