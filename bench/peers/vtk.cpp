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
#include <vtkVersion.h>

#include "peers/peers.h"

namespace tegata::bench {
namespace {

vtkSmartPointer<vtkImageData> image_of(FlatField& field) {
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(field.points, field.points, field.points);
  const auto spacing = static_cast<double>(field.spacing);
  image->SetSpacing(spacing, spacing, spacing);
  const vtkNew<vtkFloatArray> values;
  constexpr int kStaysOurs = 1;
  values->SetArray(field.values.data(), static_cast<vtkIdType>(field.values.size()), kStaysOurs);
  image->GetPointData()->SetScalars(values);
  return image;
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
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3)
    points->InsertNextPoint(&mesh.vertices[i]);
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

FlatMesh flat(vtkPolyData& poly_data) {
  FlatMesh mesh;
  for (vtkIdType i = 0; i < poly_data.GetNumberOfPoints(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      mesh.vertices.push_back(static_cast<float>(poly_data.GetPoint(i)[axis]));
    }
  }
  const vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < poly_data.GetPolys()->GetNumberOfCells(); ++i) {
    poly_data.GetPolys()->GetCellAtId(i, corners);
    for (vtkIdType c = 0; c < 3; ++c) {
      mesh.triangles.push_back(static_cast<std::uint32_t>(corners->GetId(c)));
    }
  }
  return mesh;
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

Work vtk_flying_edges(std::shared_ptr<FlatField> field, bool normals) {
  return isosurface<vtkFlyingEdges3D>(std::move(field), normals);
}

Work vtk_marching_cubes(std::shared_ptr<FlatField> field, bool normals) {
  return isosurface<vtkMarchingCubes>(std::move(field), normals);
}

MeshWork vtk_quadric_decimation(const FlatMesh& mesh, std::size_t triangle_count) {
  return decimation<vtkQuadricDecimation>(mesh, triangle_count, {});
}

MeshWork vtk_decimate_pro(const FlatMesh& mesh, std::size_t triangle_count) {
  return decimation<vtkDecimatePro>(mesh, triangle_count,
                                    [](vtkDecimatePro& filter) { filter.PreserveTopologyOn(); });
}

}  // namespace tegata::bench
