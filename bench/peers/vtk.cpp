// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

constexpr int kStaysOurs = 1;  // of an array that VTK is not to free

vtkSmartPointer<vtkImageData> image_of(FlatField& field) {
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(field.points, field.points, field.points);
  const auto spacing = static_cast<double>(field.spacing);
  image->SetSpacing(spacing, spacing, spacing);
  const vtkNew<vtkFloatArray> values;
  values->SetArray(field.values.data(), static_cast<vtkIdType>(field.values.size()), kStaysOurs);
  image->GetPointData()->SetScalars(values);
  return image;
}

FlatMesh flat(vtkPolyData& poly_data) {
  FlatMesh mesh;
  const auto point_count = static_cast<std::size_t>(poly_data.GetNumberOfPoints());
  const auto cell_count = static_cast<std::size_t>(poly_data.GetNumberOfPolys());
  mesh.vertices.reserve(3 * point_count);
  for (std::size_t i = 0; i < point_count; ++i) {
    double point[3];
    poly_data.GetPoint(static_cast<vtkIdType>(i), point);
    for (const double x : point) mesh.vertices.push_back(static_cast<float>(x));
  }
  mesh.triangles.reserve(3 * cell_count);
  vtkCellArray& cells = *poly_data.GetPolys();
  for (std::size_t i = 0; i < cell_count; ++i) {
    vtkIdType corner_count = 0;
    const vtkIdType* corners = nullptr;
    cells.GetCellAtId(static_cast<vtkIdType>(i), corner_count, corners);
    for (int c = 0; c < 3; ++c) mesh.triangles.push_back(static_cast<std::uint32_t>(corners[c]));
  }
  return mesh;
}

template <typename Filter>
Work isosurface(std::shared_ptr<FlatField> field, bool normals) {
  const vtkSmartPointer<vtkImageData> image = image_of(*field);
  return [field = std::move(field), image, normals] {
    const vtkNew<Filter> filter;
    filter->SetInputData(image);
    filter->SetValue(0, 0.0);
    filter->SetComputeNormals(normals);
    filter->SetComputeGradients(false);
    filter->SetComputeScalars(false);
    filter->Update();
    return static_cast<std::size_t>(filter->GetOutput()->GetNumberOfPolys());
  };
}

vtkSmartPointer<vtkPolyData> poly_data_of(const FlatMesh& mesh) {
  const vtkNew<vtkPoints> points;
  const float* vertices = mesh.vertices.data();
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) points->InsertNextPoint(vertices + i);
  const vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const std::array<vtkIdType, 3> corners = {mesh.triangles[i], mesh.triangles[i + 1],
                                              mesh.triangles[i + 2]};
    triangles->InsertNextCell(3, corners.data());
  }
  const auto poly_data = vtkSmartPointer<vtkPolyData>::New();
  poly_data->SetPoints(points);
  poly_data->SetPolys(triangles);
  return poly_data;
}

template <typename Filter>
MeshWork decimation(const FlatMesh& mesh, std::size_t triangle_count,
                    const std::function<void(Filter&)>& set) {
  const double reduction = 1.0 - static_cast<double>(triangle_count) /
                                     (static_cast<double>(mesh.triangles.size()) / 3.0);
  const vtkSmartPointer<vtkPolyData> input = poly_data_of(mesh);
  const auto output = vtkSmartPointer<vtkPolyData>::New();
  return {[=] {
            const vtkNew<Filter> filter;
            filter->SetInputData(input);
            filter->SetTargetReduction(reduction);
            if (set) set(*filter);
            filter->Update();
            output->ShallowCopy(filter->GetOutput());
            return static_cast<std::size_t>(output->GetNumberOfPolys());
          },
          [=] { return flat(*output); }};
}

}  // namespace

std::string vtk_version() { return vtkVersion::GetVTKVersion(); }

void hold_vtk_to_one_thread() {
  vtkSMPTools::SetBackend("Sequential");
  vtkSMPTools::Initialize(1);
}

void give_vtk_threads(int threads) {
  if (threads == 1) return hold_vtk_to_one_thread();
  vtkSMPTools::SetBackend("TBB");
  vtkSMPTools::Initialize(threads);
}

Work vtk_flying_edges(std::shared_ptr<FlatField> field, bool normals) {
  return isosurface<vtkFlyingEdges3D>(std::move(field), normals);
}

Work vtk_marching_cubes(std::shared_ptr<FlatField> field, bool normals) {
  return isosurface<vtkMarchingCubes>(std::move(field), normals);
}

FlatMesh vtk_surface_of_voxels(std::vector<std::uint8_t>& inside, int voxels) {
  const vtkNew<vtkImageData> image;
  image->SetDimensions(voxels, voxels, voxels);
  const vtkNew<vtkUnsignedCharArray> values;
  values->SetArray(inside.data(), static_cast<vtkIdType>(inside.size()), kStaysOurs);
  image->GetPointData()->SetScalars(values);
  const vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.5);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  return flat(*filter->GetOutput());
}

MeshWork vtk_quadric_decimation(const FlatMesh& mesh, std::size_t triangle_count) {
  return decimation<vtkQuadricDecimation>(mesh, triangle_count, {});
}

MeshWork vtk_decimate_pro(const FlatMesh& mesh, std::size_t triangle_count) {
  return decimation<vtkDecimatePro>(mesh, triangle_count,
                                    [](vtkDecimatePro& filter) { filter.PreserveTopologyOn(); });
}

}  // namespace tegata::bench
