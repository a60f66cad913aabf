// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tegata/base/error.h"
#include "tegata/mesh/shapes_for_tests.h"

namespace tegata {
namespace {

class MeshFile : public testing::Test {
 protected:
  std::filesystem::path path(const std::string& ending) const {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::path(testing::TempDir()) /
           (std::string("tegata_mesh_") + test->name() + ending);
  }
  std::filesystem::path write(const std::string& bytes, const std::string& ending) const {
    std::ofstream(path(ending), std::ios::binary) << bytes;
    return path(ending);
  }
  // The message of the error that reading throws; empty where it throws none.
  std::string error_of_ply(const std::string& bytes) const {
    try {
      read_ply(write(bytes, ".ply"));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::string error_of_obj(const std::string& bytes) const {
    try {
      read_obj(write(bytes, ".obj"));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string ascii_triangle(const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n" +
         faces;
}

TEST_F(MeshFile, AnObjComesBackAsItWasWritten) {
  TriangleMesh mesh = shapes::torus(0.125, 0.03125, 20, 10);
  for (const bool has_normals : {false, true}) {
    if (has_normals) mesh.normals = vertex_normals(mesh);
    write_obj(mesh, path(".obj"));
    const TriangleMesh back = read_obj(path(".obj"));
    ASSERT_EQ(back.vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      EXPECT_LT((back.vertices[v] - mesh.vertices[v]).norm(), 1e-9);
    }
    EXPECT_EQ(back.triangles, mesh.triangles);
  }
}

TEST_F(MeshFile, APlyComesBackAsItWasWritten) {
  TriangleMesh mesh = shapes::torus(0.125, 0.03125, 20, 10);
  mesh.normals = vertex_normals(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.unproven.push_back(v % 3 == 0);
  write_ply(mesh, path(".ply"));
  const TriangleMesh back = read_ply(path(".ply"));
  ASSERT_EQ(back.vertices.size(), mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_LT((back.vertices[v] - mesh.vertices[v]).norm(), 1e-7);
    EXPECT_LT((back.normals[v] - mesh.normals[v]).norm(), 1e-6);
  }
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.unproven, mesh.unproven);
}

TEST_F(MeshFile, ConfidencesFollowTheirVerticesAndDisturbNoReader) {
  TriangleMesh mesh = shapes::unit_cube();
  mesh.normals = vertex_normals(mesh);
  const std::vector<float> confidence(mesh.vertices.size(), 0.25F);
  write_ply(mesh, path(".ply"), confidence);
  const TriangleMesh back = read_ply(path(".ply"));
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_EQ(back.triangles, mesh.triangles);
  std::ifstream stream(path(".ply"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  const std::size_t first_vertex = bytes.find("end_header\n") + 11;
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + first_vertex + 6 * sizeof(float), sizeof(float));
  EXPECT_EQ(value, 0.25F);
  EXPECT_THROW(write_ply(mesh, path(".ply"), std::span(confidence).first(3)), Error);
}

TEST_F(MeshFile, APlyWithoutNormalsAndMarksHasNone) {
  write_ply(shapes::unit_cube(), path(".ply"));
  const TriangleMesh back = read_ply(path(".ply"));
  EXPECT_EQ(back.vertices, shapes::unit_cube().vertices);
  EXPECT_TRUE(back.normals.empty());
  EXPECT_TRUE(back.unproven.empty());
}

TEST_F(MeshFile, EveryTruncationOfAPlyIsAnErrorThatNamesTheFile) {
  write_ply(shapes::unit_cube(), path("_whole.ply"));
  const std::string whole = bytes_of(path("_whole.ply"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string message = error_of_ply(whole.substr(0, length));
    ASSERT_NE(message.find(path(".ply").string()), std::string::npos) << length << " bytes";
    ASSERT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_EQ(error_of_ply(whole), "");
}

TEST_F(MeshFile, ReadsAsciiQuadsOtherElementsAndOtherProperties) {
  const auto file = write(
      "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nelement camera 1\r\n"
      "property list uchar float view\r\nelement vertex 4\r\nproperty double x\r\n"
      "property uchar red\r\nproperty double y\r\nproperty double z\r\nelement face 1\r\n"
      "property uint flags\r\nproperty list uint8 uint32 vertex_index\r\nend_header\r\n"
      "2 0.5 0.5\r\n0 255 0 0\r\n1 255 0 0\r\n1 255 1 0\r\n0 255 1 1e-3\r\n7 4 0 1 2 3\r\n",
      ".ply");
  const TriangleMesh mesh = read_ply(file);
  ASSERT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.vertices[3], Eigen::Vector3d(0.0, 1.0, 1e-3));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(MeshFile, RefusesPlysThatLieAboutTheirContent) {
  EXPECT_EQ(error_of_ply(ascii_triangle("3 0 1 2\n")), "");
  EXPECT_NE(error_of_ply(ascii_triangle("3 0 1 -2\n")).find("face 0"), std::string::npos);
  EXPECT_NE(error_of_ply(ascii_triangle("3 0 1 3\n")).find("vertex 3"), std::string::npos);
  EXPECT_NE(error_of_ply(ascii_triangle("3 0 1 0.5\n")), "");
  EXPECT_NE(error_of_ply(ascii_triangle("2 0 1\n")).find("2 corners"), std::string::npos);
  EXPECT_NE(error_of_ply(ascii_triangle("3 0 one 2\n")).find("'one'"), std::string::npos);
  EXPECT_NE(error_of_ply(ascii_triangle("4294967295 0 1 2\n")).find("truncated"),
            std::string::npos);
}

TEST_F(MeshFile, RefusesPlyHeadersThatItCannotFollow) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string bytes = ascii_triangle("3 0 1 2\n");
    return bytes.replace(bytes.find(from), from.size(), to);
  };
  EXPECT_NE(error_of_ply(with("ply", "plx")), "");
  EXPECT_NE(error_of_ply(with("ascii", "binary_big_endian")).find("binary_big_endian"),
            std::string::npos);
  EXPECT_NE(error_of_ply(with("format ascii 1.0\n", "")), "");
  EXPECT_NE(error_of_ply(with("property float y", "property quad y")).find("'quad'"),
            std::string::npos);
  EXPECT_NE(error_of_ply(with("property float y", "property float w")), "");
  EXPECT_NE(error_of_ply(with("vertex 3", "vertex 99999999999999")).find("truncated"),
            std::string::npos);
  EXPECT_NE(error_of_ply(with("vertex 3", "vertex -3")), "");
  EXPECT_NE(error_of_ply(with("element vertex", "element point")), "");
  EXPECT_NE(error_of_ply(with("end_header", "end_of_header")), "");
  EXPECT_NE(error_of_ply(with("0 1 0", "0 nan 0")), "");
}

TEST_F(MeshFile, RefusesFilesThatAreNotThere) {
  EXPECT_THROW(read_ply(path("_absent.ply")), Error);
  EXPECT_THROW(read_obj(path("_absent.obj")), Error);
  EXPECT_THROW(write_ply(shapes::unit_cube(), path("_absent_folder") / "mesh.ply"), Error);
}

TEST_F(MeshFile, SaysWhenTheDiskIsFull) {
  const std::filesystem::path full = "/dev/full";
  if (!std::filesystem::exists(full)) GTEST_SKIP() << "no device that is always full";
  EXPECT_THROW(write_ply(shapes::unit_cube(), full), Error);
}

TEST_F(MeshFile, ReadsObjFacesOfEveryNotation) {
  const auto file = write(
      "# a comment\nv 0 0 0\nv 1.5 0 0 1.0\nv +1 1 0\nvt 0 0\nvn 0 0 1\nv 0 1 -1e-2\n\n"
      "g piece\nf 1/1/1 2//1 3/1 4\r\nf -4 -3 -2\n",
      ".obj");
  const TriangleMesh mesh = read_obj(file);
  ASSERT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.vertices[3], Eigen::Vector3d(0.0, 1.0, -0.01));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
}

TEST_F(MeshFile, RefusesObjLinesByNumber) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(error_of_obj(vertices + "f 1 2 3\n"), "");
  EXPECT_NE(error_of_obj(vertices + "f 1 2 4\n").find(":4:"), std::string::npos);
  EXPECT_NE(error_of_obj(vertices + "f 0 1 2\n").find("'0'"), std::string::npos);
  EXPECT_NE(error_of_obj(vertices + "f -4 1 2\n").find("'-4'"), std::string::npos);
  EXPECT_NE(error_of_obj(vertices + "f 1 2\n").find("2 corners"), std::string::npos);
  EXPECT_NE(error_of_obj("v 0 zero 0\n").find(":1:"), std::string::npos);
  EXPECT_NE(error_of_obj("v 0 1\n").find(":1:"), std::string::npos);
}

}  // namespace
}  // namespace tegata
