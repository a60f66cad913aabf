// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/base/instruction_set.h"

#include <gtest/gtest.h>

namespace tegata {
namespace {

TEST(InstructionSet, TheBestOneIsSupportedAndEveryMachineHasTheBaseline) {
  EXPECT_TRUE(is_supported(InstructionSet::baseline));
  EXPECT_TRUE(is_supported(best_instruction_set()));
  for (const InstructionSet set : kInstructionSets) {
    EXPECT_TRUE(set <= best_instruction_set() || !is_supported(set)) << instruction_set_name(set);
  }
}

}  // namespace
}  // namespace tegata
