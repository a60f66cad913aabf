// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace tegata {

/// Calls body(i) for each i in 0 .. count - 1 on at most `threads` threads (0: one per core; never
/// more), in any order. Bodies must not write to shared data; whatever is reduced is reduced
/// afterwards in the order of i, so that results do not depend on the number of threads. An
/// exception of a body is rethrown here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace tegata
