// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <bit>
#include <cmath>

#include "benchmarks.h"
#include "pair_fit.h"
#include "report.h"

namespace tegata::bench {
namespace {

constexpr double kMostDifference = 1e-4;  // of the costs at the end, relative

struct Peer {
  std::string name;
  FitWork work;
  double bar = 0.0;
};

// Ours and the peers on one problem; the costs at the end must agree.
void run_case(const std::string& name, const PairFit& fit, const std::vector<Peer>& peers,
              Report& report) {
  const auto ours = [&](FitEnd (*run)(const PairFit&)) {
    return [&fit, run] {
      return std::bit_cast<std::size_t>(run(fit).estimate.world_from_hand[0].translation.x());
    };
  };
  std::vector<Contestant> contestants = {{"tegata SurfacePairs", ours(run_pair_fit)}};
  for (const Peer& peer : peers) contestants.push_back({peer.name, peer.work.run, peer.bar});
  contestants.push_back({"tegata, pair by pair", ours(run_plainly)});
  report.add(name, contestants, run_rounds(contestants));

  const FitEnd end = run_pair_fit(fit);
  const double cost = cost_of(fit, end.estimate);
  std::string steps = fmt::format("{}: steps that lowered the cost: tegata {}", name, end.steps);
  for (const Peer& peer : peers) {
    const double difference = std::abs(cost / peer.work.cost() - 1.0);
    report.check(fmt::format("{}: the cost of {}, to 1e-4", name, peer.name),
                 fmt::format("{:.6g} against {:.6g}", cost, peer.work.cost()),
                 difference <= kMostDifference);
    steps += fmt::format(", {} {}", peer.name, peer.work.steps());
  }
  report.note(steps);
}

}  // namespace

bool benchmark_fit() {
  Report report("B5: 2,000 pairs, 26 parameters, 10 iterations");
  const PairFit fit = make_pair_fit(1, 2000);
  const FlatFit flat = flat_fit(fit);
  run_case("one frame", fit,
           {{"ceres::TinySolver", tiny_solver_fit(flat), 15.0},
            {"Ceres DENSE_NORMAL_CHOLESKY",
             ceres_fit(flat, CeresSolver::dense_normal_cholesky, false), 30.0},
            {"Ceres DENSE_QR", ceres_fit(flat, CeresSolver::dense_qr, false), 30.0}},
           report);
  return report.print();
}

bool benchmark_joint() {
  Report report("B6: 30 frames of 2,000 pairs, 20 + 180 parameters, 10 iterations");
  const PairFit fit = make_pair_fit(30, 2000);
  const FlatFit flat = flat_fit(fit);
  const auto sparse = CeresSolver::sparse_normal_cholesky, schur = CeresSolver::sparse_schur;
  run_case("30 frames", fit,
           {{"Ceres SPARSE_NORMAL_CHOLESKY", ceres_fit(flat, sparse, false), 40.0},
            {"Ceres SPARSE_SCHUR", ceres_fit(flat, schur, false), 40.0},
            {"Ceres SPARSE_NORMAL_CHOLESKY, by digit", ceres_fit(flat, sparse, true)},
            {"Ceres SPARSE_SCHUR, by digit", ceres_fit(flat, schur, true)}},
           report);
  return report.print();
}

}  // namespace tegata::bench
