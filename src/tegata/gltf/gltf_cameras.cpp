// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/gltf/gltf_cameras.h"

#include <tiny_gltf.h>

#include <cmath>
#include <initializer_list>

namespace tegata {
namespace {

tinygltf::Value list(const double* begin, const double* end) {
  tinygltf::Value::Array numbers;
  for (; begin != end; ++begin) numbers.emplace_back(*begin);
  return tinygltf::Value(std::move(numbers));
}

tinygltf::Value list(std::initializer_list<double> numbers) {
  return list(numbers.begin(), numbers.end());
}

}  // namespace

int add_gltf_camera(const Camera& camera, tinygltf::Model& model) {
  constexpr double kNearest = 0.01, kFarthest = 100.0;  // what is drawn [m]
  tinygltf::Camera described;
  described.name = camera.name;
  described.type = "perspective";
  described.perspective.yfov = 2.0 * std::atan(0.5 * camera.height / camera.fy);
  described.perspective.aspectRatio = camera.width * camera.fy / (camera.height * camera.fx);
  described.perspective.znear = kNearest;
  described.perspective.zfar = kFarthest;
  tinygltf::Value::Object extras;
  extras["matrix"] = list({camera.fx, camera.fy, camera.cx, camera.cy});
  extras["size"] = list({static_cast<double>(camera.width), static_cast<double>(camera.height)});
  extras["distortions"] =
      list(camera.distortion.data(), camera.distortion.data() + camera.distortion.size());
  described.extras = tinygltf::Value(std::move(extras));
  model.cameras.push_back(described);

  const Rigid3d opencv_from_gltf{Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0), Eigen::Vector3d::Zero()};
  const Rigid3d place = camera.camera_from_world.inverse() * opencv_from_gltf;
  tinygltf::Node node;
  node.name = camera.name;
  node.camera = static_cast<int>(model.cameras.size()) - 1;
  node.rotation = {place.rotation.x(), place.rotation.y(), place.rotation.z(), place.rotation.w()};
  node.translation = {place.translation.x(), place.translation.y(), place.translation.z()};
  model.nodes.push_back(node);
  return static_cast<int>(model.nodes.size()) - 1;
}

}  // namespace tegata
