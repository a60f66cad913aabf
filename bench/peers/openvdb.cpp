// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

using DenseGrid = openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ>;

constexpr float kBand = 3.0f;  // cells beyond which the field is cut off, as level sets are

openvdb::FloatGrid::Ptr sparse(const DenseGrid& dense, float spacing) {
  const auto grid = openvdb::FloatGrid::create(kBand * spacing);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(static_cast<double>(spacing)));
  openvdb::tools::copyFromDense(dense, *grid, 0.0f);
  return grid;
}

std::size_t mesh_size(const openvdb::FloatGrid& grid) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(grid, points, quads, 0.0);
  return quads.size();
}

}  // namespace

std::string openvdb_version() { return openvdb::getLibraryVersionString(); }

std::shared_ptr<void> hold_openvdb_to_one_thread() {
  openvdb::initialize();
  return std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, 1);
}

Work openvdb_volume_to_mesh(const std::shared_ptr<FlatField>& field, bool with_copy) {
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(field->points - 1));
  const auto dense = std::make_shared<DenseGrid>(box);
  const float spacing = field->spacing, most = kBand * spacing;
  std::transform(field->values.begin(), field->values.end(), dense->data(),
                 [=](float value) { return std::clamp(-value, -most, most); });
  if (with_copy) return [=] { return mesh_size(*sparse(*dense, spacing)); };
  const openvdb::FloatGrid::Ptr grid = sparse(*dense, spacing);
  return [=] { return mesh_size(*grid); };
}

}  // namespace tegata::bench
