// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <stdexcept>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const FlatMesh& flat) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  const auto& v = flat.vertices;
  for (std::size_t i = 0; i < v.size(); i += 3) {
    vertices.push_back(mesh.add_vertex(
        {static_cast<double>(v[i]), static_cast<double>(v[i + 1]), static_cast<double>(v[i + 2])}));
  }
  const auto& t = flat.triangles;
  for (std::size_t i = 0; i < t.size(); i += 3) {
    if (mesh.add_face(vertices[t[i]], vertices[t[i + 1]], vertices[t[i + 2]]) ==
        Mesh::null_face()) {
      throw std::runtime_error("bench: CGAL takes no mesh that is not manifold");
    }
  }
  return mesh;
}

FlatMesh flat(Mesh mesh) {
  mesh.collect_garbage();
  FlatMesh simplified;
  for (const Mesh::Vertex_index vertex : mesh.vertices()) {
    for (int axis = 0; axis < 3; ++axis) {
      simplified.vertices.push_back(static_cast<float>(mesh.point(vertex)[axis]));
    }
  }
  for (const Mesh::Face_index face : mesh.faces()) {
    for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      simplified.triangles.push_back(static_cast<std::uint32_t>(vertex));
    }
  }
  return simplified;
}

// The mesh is changed in place, so the time includes a copy of it, 1 ms of some hundred.
MeshWork edge_collapse(const FlatMesh& mesh, const std::function<void(Mesh&)>& collapse) {
  const auto input = std::make_shared<Mesh>(mesh_of(mesh));
  const auto output = std::make_shared<Mesh>();
  return {[=] {
            *output = *input;
            collapse(*output);
            return static_cast<std::size_t>(output->number_of_faces());
          },
          [=] { return flat(*output); }};
}

sms::Count_stop_predicate<Mesh> stop_at(std::size_t triangle_count) {
  return sms::Count_stop_predicate<Mesh>(3 * triangle_count / 2);  // edges
}

}  // namespace

std::string cgal_version() { return CGAL_VERSION_STR; }

MeshWork cgal_lindstrom_turk(const FlatMesh& mesh, std::size_t triangle_count) {
  return edge_collapse(
      mesh, [=](Mesh& collapsed) { sms::edge_collapse(collapsed, stop_at(triangle_count)); });
}

MeshWork cgal_garland_heckbert(const FlatMesh& mesh, std::size_t triangle_count) {
  return edge_collapse(mesh, [=](Mesh& collapsed) {
    const sms::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(collapsed);
    sms::edge_collapse(
        collapsed, stop_at(triangle_count),
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  });
}

}  // namespace tegata::bench
