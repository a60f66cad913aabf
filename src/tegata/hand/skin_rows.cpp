// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/hand/skin_rows.h"

#include <algorithm>
#include <bit>

namespace tegata {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

using PartSet = std::uint32_t;  // as bits

std::size_t first_of(PartSet parts) { return static_cast<std::size_t>(std::countr_zero(parts)); }

// What a bone adds to a vertex's parts and which of its part's weights is its own.
struct BonePlace {
  PartSet part;  // none for the palm
  std::size_t weight;
};
constexpr std::array<BonePlace, kBoneCount> kPlaces = [] {
  std::array<BonePlace, kBoneCount> places{};
  for (std::size_t bone = 1; bone < places.size(); ++bone) {
    places[bone] = {PartSet{1} << (bone - 1) / 3, 1 + (bone - 1) % 3};
  }
  return places;
}();

PartSet parts_that_move(const SkinLinks& links) {
  PartSet parts = 0;
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (links.weights[i] > 0.0) parts |= kPlaces[index(links.bones[i])].part;
  }
  return parts != 0 ? parts : PartSet{1} << SkinRows::kPalmPart;
}

// Of the palm and the three bones of a digit.
std::array<double, 4> weights_in_part(const SkinLinks& links, std::size_t part, bool with_palm) {
  std::array<double, 4> weights = {};
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (!(links.weights[i] > 0.0)) continue;
    const BonePlace& place = kPlaces[index(links.bones[i])];
    const bool is_in = place.part == 0 ? with_palm : (place.part >> part & 1u) != 0;
    if (is_in) weights[place.weight] += links.weights[i];
  }
  return weights;
}

std::array<float, 3> single(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

// The centres of the joints that bones hang from, at rest; the hand's origin for the palm and for
// no bone.
std::array<Eigen::Vector3d, kBoneCount + 1> rest_centers(const HandModel& model) {
  const auto axes = joint_axes(model.skeleton, model.rest_angles);
  std::array<Eigen::Vector3d, kBoneCount + 1> centers;
  centers.front().setZero();
  centers.back().setZero();
  for (std::size_t angle = 0; angle < axes.size(); ++angle) {
    centers[index(bone_of_angle(static_cast<int>(angle)))] = axes[angle].center;
  }
  return centers;
}

// What a bone and the one that it hangs from weigh; nothing where others weigh something.
struct HingeWeights {
  std::size_t bone = SkinRows::kNoBone;
  double beyond = 0.0, before = 0.0;
};
HingeWeights hinge_weights(const SkinLinks& links) {
  int bone = 0;
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (links.weights[i] > 0.0) bone = std::max(bone, links.bones[i]);
  }
  HingeWeights weights{index(bone)};
  for (std::size_t i = 0; i < links.bones.size(); ++i) {
    if (!(links.weights[i] > 0.0)) continue;
    if (links.bones[i] == bone) {
      weights.beyond += links.weights[i];
    } else if (links.bones[i] == parent_bone(bone)) {
      weights.before += links.weights[i];
    } else {
      return {};
    }
  }
  return weights;
}

void repeat_row(std::vector<SkinRows::Block>& blocks, std::size_t row, std::size_t end) {
  const auto repeat = [&](RowLanes& to, const RowLanes& from, std::size_t at) {
    to[at % kRowLanes] = from[row % kRowLanes];
  };
  const SkinRows::Block from = blocks[row / kRowLanes];
  for (std::size_t at = row + 1; at < end; ++at) {
    SkinRows::Block& to = blocks[at / kRowLanes];
    for (std::size_t i = 0; i < 3; ++i) {
      repeat(to.position[i], from.position[i], at);
      repeat(to.normal[i], from.normal[i], at);
    }
    for (std::size_t i = 0; i < 4; ++i) repeat(to.weights[i], from.weights[i], at);
  }
}

}  // namespace

SkinRows::SkinRows(const HandModel& model) {
  const TriangleMesh& surface = model.rest_surface;
  std::vector<PartSet> sets(model.links.size());
  std::array<std::size_t, kDigitCount + 1> counts = {};
  for (std::size_t vertex = 0; vertex < sets.size(); ++vertex) {
    sets[vertex] = parts_that_move(model.links[vertex]);
    for (PartSet left = sets[vertex]; left != 0; left &= left - 1) ++counts[first_of(left)];
  }
  std::array<std::size_t, kDigitCount + 1> next;  // free row of each part
  std::size_t block_count = 0;
  for (std::size_t part = 0; part < counts.size(); ++part) {
    next[part] = block_count * kRowLanes;
    parts_[part].first = block_count;
    block_count += (counts[part] + kRowLanes - 1) / kRowLanes;
    parts_[part].last = block_count;
  }
  blocks_.resize(block_count);
  first_row_.resize(sets.size());
  hinged_.reserve(sets.size());
  hinge_.reserve(sets.size());
  const auto centers = rest_centers(model);
  for (std::size_t vertex = 0; vertex < sets.size(); ++vertex) {
    const HingeWeights hinge = hinge_weights(model.links[vertex]);
    hinge_.push_back(static_cast<std::uint8_t>(hinge.bone));
    const Eigen::Vector3d arm = surface.vertices[vertex] - centers[hinge.bone];
    hinged_.push_back({single(hinge.beyond * arm), single(hinge.before * arm)});
    const bool is_shared = !std::has_single_bit(sets[vertex]);
    if (is_shared) shared_.push_back({static_cast<std::uint32_t>(vertex), {}});
    bool is_first = true;
    for (PartSet left = sets[vertex]; left != 0; left &= left - 1) {
      const std::size_t part = first_of(left);
      const std::size_t row = next[part]++, lane = row % kRowLanes;
      Block& block = blocks_[row / kRowLanes];
      const auto weights = weights_in_part(model.links[vertex], part, is_first);
      for (std::size_t i = 0; i < 4; ++i) block.weights[i][lane] = weights[i];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        block.position[i][lane] = surface.vertices[vertex][axis];
        block.normal[i][lane] =
            vertex < surface.normals.size() ? surface.normals[vertex][axis] : 0.0;
      }
      if (is_first) first_row_[vertex] = static_cast<std::uint32_t>(row);
      if (is_shared) shared_.back().rows.push_back(static_cast<std::uint32_t>(row));
      is_first = false;
    }
  }
  for (std::size_t part = 0; part < counts.size(); ++part) {
    if (counts[part] > 0) repeat_row(blocks_, next[part] - 1, parts_[part].last * kRowLanes);
  }
}

std::size_t SkinRows::part_of_row(std::size_t row) const {
  // Asked for rows in no order: counting is faster than guessing where to stop.
  const std::size_t block = row / kRowLanes;
  std::size_t part = 0;
  for (std::size_t p = 0; p < kPalmPart; ++p) part += block >= parts_[p].last ? 1 : 0;
  return part;
}

const SkinRows::SharedVertex* SkinRows::shared(std::size_t vertex) const {
  const auto found = std::lower_bound(
      shared_.begin(), shared_.end(), vertex,
      [](const SharedVertex& shared, std::size_t value) { return shared.vertex < value; });
  return found != shared_.end() && found->vertex == vertex ? &*found : nullptr;
}

}  // namespace tegata
