// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/pipeline/frame_store.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace tegata {
namespace {

// A run of pixels of one label: its length above its label.
constexpr std::uint32_t kLongestRun = (1u << 24) - 1;
constexpr int kLabelBits = 8;

std::vector<std::uint32_t> runs_of(const Silhouette& silhouette) {
  std::vector<std::uint32_t> runs;
  const std::vector<PixelLabel>& labels = silhouette.values();
  for (auto at = labels.begin(); at != labels.end();) {
    const auto most = std::min<std::ptrdiff_t>(kLongestRun, labels.end() - at);
    const auto end = std::find_if(at, at + most, [&](PixelLabel label) { return label != *at; });
    runs.push_back(static_cast<std::uint32_t>(end - at) << kLabelBits |
                   static_cast<std::uint32_t>(*at));
    at = end;
  }
  return runs;
}

Silhouette silhouette_of(const std::vector<std::uint32_t>& runs, const Camera& camera) {
  Silhouette silhouette(camera.width, camera.height);
  auto next = silhouette.values().begin();
  for (const std::uint32_t run : runs) {
    next = std::fill_n(next, run >> kLabelBits, static_cast<PixelLabel>(run & 0xff));
  }
  return silhouette;
}

// Lists of numbers one after the other, each behind its length.
class NumberWriter {
 public:
  template <typename T>
  void put(const T* numbers, std::size_t count) {
    append(&count, 1);
    append(numbers, count);
  }
  void put(const std::vector<Eigen::Vector3d>& points) {
    put(points.empty() ? nullptr : points.front().data(), 3 * points.size());
  }
  std::vector<std::byte> bytes() && { return std::move(bytes_); }

 private:
  template <typename T>
  void append(const T* numbers, std::size_t count) {
    const auto bytes = std::as_bytes(std::span(numbers, count));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }

  std::vector<std::byte> bytes_;
};

class NumberReader {
 public:
  explicit NumberReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename T>
  std::vector<T> list() {
    std::vector<T> numbers(count());
    take(numbers.data(), numbers.size() * sizeof(T));
    return numbers;
  }
  std::vector<Eigen::Vector3d> points() {
    std::vector<Eigen::Vector3d> points(count() / 3);
    if (!points.empty()) take(points.front().data(), points.size() * sizeof(Eigen::Vector3d));
    return points;
  }

 private:
  std::size_t count() {
    std::size_t count = 0;
    take(&count, sizeof(count));
    return count;
  }
  void take(void* to, std::size_t size) {
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  std::span<const std::byte> bytes_;
};

void put_mesh(const TriangleMesh& mesh, NumberWriter& writer) {
  writer.put(mesh.vertices);
  writer.put(mesh.triangles.data(), mesh.triangles.size());
  writer.put(mesh.normals);
  writer.put(mesh.unproven.data(), mesh.unproven.size());
}

TriangleMesh next_mesh(NumberReader& reader) {
  TriangleMesh mesh;
  mesh.vertices = reader.points();
  mesh.triangles = reader.list<Triangle>();
  mesh.normals = reader.points();
  mesh.unproven = reader.list<std::uint8_t>();
  return mesh;
}

// The position of a view's camera among those that are known, from now on.
std::uint32_t index_among(std::vector<Camera>& cameras, const Camera& camera) {
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const Camera& known) { return known.name == camera.name; });
  const auto index = static_cast<std::uint32_t>(found - cameras.begin());
  if (found == cameras.end()) cameras.push_back(camera);
  return index;
}

std::vector<HullView> next_views(NumberReader& reader, const std::vector<Camera>& cameras) {
  std::vector<HullView> views;
  for (const std::uint32_t index : reader.list<std::uint32_t>()) {
    views.push_back({cameras[index], silhouette_of(reader.list<std::uint32_t>(), cameras[index])});
  }
  return views;
}

}  // namespace

FrameStore::FrameStore(const std::filesystem::path& folder) {
  if (!folder.empty()) file_.emplace(folder);
}

void FrameStore::add(PreparedFrame frame) {
  NumberWriter writer;
  put_mesh(std::exchange(frame.hull, {}), writer);
  frame.frame.hull.reset();
  const std::vector<FitView> views = std::exchange(frame.frame.views, {});
  std::vector<std::uint32_t> indices;
  for (const FitView& view : views) indices.push_back(index_among(cameras_, view.camera));
  writer.put(indices.data(), indices.size());
  for (const FitView& view : views) {
    const std::vector<std::uint32_t> runs = runs_of(view.silhouette);
    writer.put(runs.data(), runs.size());
  }
  StoredFrame& stored = frames_.emplace_back();
  stored.brief = std::move(frame);
  if (file_) {
    stored.place = file_->append(std::move(writer).bytes());
  } else {
    stored.bytes = std::move(writer).bytes();
    stored.bytes.shrink_to_fit();
  }
}

void FrameStore::set_landmarks(std::size_t i, const std::optional<StartLandmarks>& landmarks) {
  frames_[i].brief.frame.landmarks = landmarks;
}

std::vector<std::byte> FrameStore::bytes_of(std::size_t i) const {
  return file_ ? file_->read(frames_[i].place) : frames_[i].bytes;
}

TriangleMesh FrameStore::hull(std::size_t i) const {
  const std::vector<std::byte> bytes = bytes_of(i);
  NumberReader reader(bytes);
  return next_mesh(reader);
}

std::vector<HullView> FrameStore::views(std::size_t i) const {
  const std::vector<std::byte> bytes = bytes_of(i);
  NumberReader reader(bytes);
  next_mesh(reader);
  return next_views(reader, cameras_);
}

PreparedFrame FrameStore::restored(std::size_t i) const {
  const std::vector<std::byte> bytes = bytes_of(i);
  NumberReader reader(bytes);
  PreparedFrame whole = frames_[i].brief;
  whole.hull = next_mesh(reader);
  for (HullView& view : next_views(reader, cameras_)) {
    whole.frame.views.push_back(make_fit_view(view.camera, std::move(view.silhouette)));
  }
  if (whole.refusal.empty()) whole.frame.hull.emplace(whole.hull);
  return whole;
}

}  // namespace tegata
