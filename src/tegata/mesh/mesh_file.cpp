// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/mesh_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

#include "tegata/base/error.h"
#include "tegata/mesh/ply_reader.h"
#include "tegata/mesh/words.h"

namespace tegata {
namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies");

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string(), ": cannot be opened for reading");
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw Error(file.string(), ": cannot be read to its end");
  return bytes;
}

template <typename T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

void put(std::string& bytes, const Eigen::Vector3d& vector) {
  for (const double value : vector) put(bytes, static_cast<float>(value));
}

void write_bytes(const std::string& bytes, const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string(), ": cannot be opened for writing");
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw Error(file.string(), ": could not be written whole: is the disk full?");
}

}  // namespace

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& file,
               std::span<const float> confidence) {
  check_mesh(mesh);
  if (!confidence.empty() && confidence.size() != mesh.vertices.size()) {
    throw Error(file.string(), ": got confidences of ", confidence.size(), " vertices, expected ",
                mesh.vertices.size());
  }
  const bool has_normals = !mesh.normals.empty(), has_marks = !mesh.unproven.empty();
  std::string bytes =
      text("ply\nformat binary_little_endian 1.0\ncomment tegata mesh, metres\nelement vertex ",
           mesh.vertices.size(), "\nproperty float x\nproperty float y\nproperty float z\n",
           has_normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
           has_marks ? "property uchar unproven\n" : "",
           confidence.empty() ? "" : "property float confidence\n", "element face ",
           mesh.triangles.size(), "\nproperty list uchar int vertex_indices\nend_header\n");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    put(bytes, mesh.vertices[v]);
    if (has_normals) put(bytes, mesh.normals[v]);
    if (has_marks) put(bytes, mesh.unproven[v]);
    if (!confidence.empty()) put(bytes, confidence[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    put(bytes, std::uint8_t{3});
    for (const std::uint32_t v : t) put(bytes, static_cast<std::int32_t>(v));
  }
  write_bytes(bytes, file);
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& file) {
  check_mesh(mesh);
  const bool has_normals = !mesh.normals.empty();
  std::ostringstream lines;
  lines.precision(9);
  lines << "# tegata mesh, metres\n";
  for (const Eigen::Vector3d& v : mesh.vertices) {
    lines << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const Eigen::Vector3d& n : mesh.normals) {
    lines << "vn " << n.x() << ' ' << n.y() << ' ' << n.z() << '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    lines << 'f';
    for (const std::uint32_t v : t) {
      lines << ' ' << v + 1;
      if (has_normals) lines << "//" << v + 1;
    }
    lines << '\n';
  }
  write_bytes(lines.str(), file);
}

TriangleMesh read_ply(const std::filesystem::path& file) {
  return parse_ply(read_whole(file), file.string());
}

TriangleMesh read_obj(const std::filesystem::path& file) {
  const std::string bytes = read_whole(file);
  std::string_view rest = bytes;
  TriangleMesh mesh;
  std::vector<std::uint32_t> face;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    std::string_view line = take_line(rest);
    const std::string_view key = take_word(line);
    const auto fail = [&](const auto&... parts) {
      throw Error(file.string(), ":", line_number, ": ", parts...);
    };
    if (key == "v") {
      Eigen::Vector3d vertex;
      for (double& value : vertex) {
        const auto number = parse<double>(take_word(line));
        if (!number || !std::isfinite(*number)) fail("a vertex without three finite numbers");
        value = *number;
      }
      mesh.vertices.push_back(vertex);
    } else if (key == "f") {
      face.clear();
      const auto vertex_count = static_cast<std::int64_t>(mesh.vertices.size());
      for (auto word = take_word(line); !word.empty(); word = take_word(line)) {
        const auto number = parse<std::int64_t>(word.substr(0, word.find('/')));
        // Counted from 1, or back from the newest vertex, which is -1.
        const std::int64_t index =
            !number ? -1 : (*number < 0 ? vertex_count + *number : *number - 1);
        if (index < 0 || index >= vertex_count) {
          fail("corner '", word.substr(0, 40), "', expected a vertex from 1 to ", vertex_count);
        }
        face.push_back(static_cast<std::uint32_t>(index));
      }
      if (face.size() < 3) fail("a face with ", face.size(), " corners, expected 3 or more");
      for (std::size_t i = 2; i < face.size(); ++i) {
        mesh.triangles.push_back({face[0], face[i - 1], face[i]});
      }
    }
  }
  return mesh;
}

}  // namespace tegata
