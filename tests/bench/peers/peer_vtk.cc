#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include "bench/peers/peer.hh"
#include "bench/peers/peer_arrays.hh"

// VTK's vtkQuadricDecimation with its defaults, on coordinates in double. Its target is the share of faces to remove.

namespace whittle::bench {
namespace {

vtkNew<vtkPolyData> poly_data_of(const IndexedMesh& input) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(input.positions.size()));
  for (std::size_t v = 0; v < input.positions.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), input.positions[v].data());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(input.faces.size()), static_cast<vtkIdType>(3 * input.faces.size()));
  for (const auto& [a, b, c] : input.faces) {
    const vtkIdType corners[3] = {a, b, c};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

IndexedMesh arrays_of(vtkPolyData& data) {
  IndexedMesh mesh;
  for (vtkIdType v = 0; v < data.GetNumberOfPoints(); ++v) {
    Vec3 p;
    data.GetPoint(v, p.data());
    mesh.positions.push_back(p);
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray& cells = *data.GetPolys();
  for (cells.InitTraversal(); cells.GetNextCell(corners) != 0;) {
    const auto corner = [&](vtkIdType i) { return static_cast<Index>(corners->GetId(i)); };
    mesh.faces.push_back({corner(0), corner(1), corner(2)});
  }
  return without_unused_vertices(mesh);
}

class Vtk : public Peer {
 public:
  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    const vtkNew<vtkPolyData> data = poly_data_of(input);
    meter.start();
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(data);
    decimation->SetTargetReduction(1 - static_cast<double>(n_faces) / static_cast<double>(input.faces.size()));
    decimation->Update();
    meter.stop();
    return arrays_of(*decimation->GetOutput());
  }
};

}  // namespace

std::unique_ptr<Peer> make_vtk() { return std::make_unique<Vtk>(); }

}  // namespace whittle::bench
