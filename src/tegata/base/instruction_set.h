// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// For the few hot loops that are compiled once for each instruction set: the loop is an inline
// function marked TEGATA_KERNEL, called from one function for each set that carries TEGATA_AVX2 or
// TEGATA_AVX512. Products and sums are never contracted (the build says so), so that all of them
// give the same bits.
#pragma once

#include <array>
#include <string_view>

#if defined(__x86_64__)
#define TEGATA_AVX2 [[gnu::target("avx2")]]
#define TEGATA_AVX512 [[gnu::target("avx512f,avx512bw,avx512dq,avx512vl")]]
#else
#define TEGATA_AVX2
#define TEGATA_AVX512
#endif
#define TEGATA_KERNEL [[gnu::always_inline]] inline

namespace tegata {

enum class InstructionSet { baseline, avx2, avx512 };

inline constexpr std::array<InstructionSet, 3> kInstructionSets = {
    InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

std::string_view instruction_set_name(InstructionSet set);

/// Whether this machine can run what was compiled for a set.
bool is_supported(InstructionSet set);

/// The last of kInstructionSets that this machine supports.
InstructionSet best_instruction_set();

}  // namespace tegata
