// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/hand_shape_file.h"

#include <gtest/gtest.h>

#include "tegata/take/staged_folder.h"
#include "tegata/take/test_folder.h"

namespace tegata {
namespace {

std::string problem_of(const std::string& content) {
  const TestFolder folder;
  write_file(folder / "anna.toml", content);
  return error_of([&] { read_hand_shape(folder / "anna.toml"); });
}

TEST(HandShapeFile, WhatIsWrittenIsReadToTheBit) {
  const TestFolder folder;
  HandShapeFile hand;
  hand.name = "an \"odd\" name";
  hand.side = Side::left;
  hand.parameters = shape_prior().mean + shape_prior().deviation / 3.0;
  hand.standard_deviations = shape_prior().deviation / 7.0;
  write_hand_shape(hand, folder / "hand.toml");
  EXPECT_TRUE(is_hand_shape_file(folder / "hand.toml"));
  const HandShapeFile again = read_hand_shape(folder / "hand.toml");
  EXPECT_EQ(again.name, hand.name);
  EXPECT_EQ(again.side, hand.side);
  EXPECT_EQ(again.parameters, hand.parameters);
  ASSERT_TRUE(again.standard_deviations.has_value());
  EXPECT_EQ(*again.standard_deviations, *hand.standard_deviations);
}

TEST(HandShapeFile, AFewParametersWillDo) {
  const TestFolder folder;
  write_file(folder / "anna.toml",
             "format = \"tegata-hand-shape\"\nversion = 1\nhand = \"right\"\n[shape]\n"
             "length = 0.175\npalm_breadth = 1\n");
  const HandShapeFile hand = read_hand_shape(folder / "anna.toml");
  EXPECT_EQ(hand.name, "anna");
  EXPECT_EQ(hand.parameters[0], 0.175);
  EXPECT_EQ(hand.parameters.tail(23), shape_prior().mean.tail(23));
  EXPECT_FALSE(hand.standard_deviations.has_value());
}

TEST(HandShapeFile, SaysWhatIsWrongWithIt) {
  const std::string head = "format = \"tegata-hand-shape\"\nversion = 1\nhand = \"right\"\n";
  EXPECT_TRUE(says(problem_of(head), "anna.toml", "shape"));
  EXPECT_TRUE(says(problem_of(head + "[shape]\nlenght = 0.18\n"), "anna.toml", "lenght", "length"));
  EXPECT_TRUE(says(problem_of(head + "[shape]\nlength = 0.018\n"), "anna.toml", "length", "0.018"));
  EXPECT_TRUE(says(problem_of(head + "[shape]\nlength = -1\n"), "anna.toml", "length", "-1"));
  EXPECT_TRUE(says(problem_of(head + "[shape]\nlength = \"long\"\n"), "length", "a string"));
  EXPECT_TRUE(says(problem_of("format = \"tegata-hand\"\n"), "format", "'tegata-hand'"));
  EXPECT_TRUE(
      says(problem_of("format = \"tegata-hand-shape\"\nversion = 2\nhand = \"right\"\n[shape]\n"),
           "version", "2", "1"));
  EXPECT_TRUE(
      says(problem_of("format = \"tegata-hand-shape\"\nversion = 1\nhand = \"both\"\n[shape]\n"),
           "hand", "'both'", "'left'"));
}

TEST(HandShapeFile, AScannedHandIsAnotherKind) {
  const TestFolder folder;
  write_file(folder / "scan.toml", "mesh = \"scan.ply\"\nhand = \"right\"\n");
  EXPECT_FALSE(is_hand_shape_file(folder / "scan.toml"));
}

}  // namespace
}  // namespace tegata
