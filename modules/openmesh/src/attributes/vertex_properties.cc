#include "whittle/openmesh/detail/attributes/vertex_properties.hh"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <algorithm>
#include <string>
#include <utility>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/attribute_functions.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/local_functions.hh"

namespace whittle {
namespace {

using OpenMesh::VertexHandle;

/// The faces around two vertices: those are the first.
struct Ring {
  IndexedMesh mesh;
  std::vector<Index> handles;
};

Ring ring_of(const OpenMesh::TriConnectivity& mesh, VertexHandle first, VertexHandle second,
             const std::function<Vec3(VertexHandle)>& position_of) {
  Ring ring;
  const auto number_of = [&](VertexHandle v) {
    const auto handle = static_cast<Index>(v.idx());
    const auto known = std::find(ring.handles.begin(), ring.handles.end(), handle);
    const auto number = static_cast<Index>(known - ring.handles.begin());
    if (known != ring.handles.end()) return number;
    ring.handles.push_back(handle);
    ring.mesh.positions.push_back(position_of(v));
    return number;
  };
  number_of(first);
  number_of(second);
  for (const VertexHandle v : {first, second}) {
    for (const OpenMesh::FaceHandle f : mesh.vf_range(v)) {
      const auto corners = face_corners(mesh, f);
      if (v == second && std::find(corners.begin(), corners.end(), first) != corners.end()) continue;
      ring.mesh.faces.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
    }
  }
  return ring;
}

/// OpenMesh's own are called "v:…", those that have no name, as modules' of decimaters, "<vprop>".
bool is_of_user(const std::string& name) {
  return !name.empty() && !name.starts_with("v:") && !name.starts_with('<') && !name.starts_with("whittle:");
}

}  // namespace

template <class Real>
bool VertexProperties::add_if(const OpenMesh::BaseProperty& property, int number) {
  if (dynamic_cast<const OpenMesh::PropertyT<Real>*>(&property) == nullptr) return false;
  add(AttributeKind::scalar, OpenMesh::VPropHandleT<Real>(number));
  return true;
}

void VertexProperties::add_those_of_user() {
  for (std::size_t i = 0; i < properties_.size(); ++i) {
    if (properties_[i] == nullptr || !is_of_user(properties_[i]->name())) continue;
    const OpenMesh::BaseProperty& property = *properties_[i];
    const int number = static_cast<int>(i);
    add_if<float>(property, number) || add_if<OpenMesh::Vec2f>(property, number) ||
        add_if<OpenMesh::Vec3f>(property, number) || add_if<OpenMesh::Vec4f>(property, number) ||
        add_if<double>(property, number) || add_if<OpenMesh::Vec2d>(property, number) ||
        add_if<OpenMesh::Vec3d>(property, number) || add_if<OpenMesh::Vec4d>(property, number);
  }
}

bool VertexProperties::fits(const OpenMesh::BaseKernel& mesh) const {
  return std::equal(mesh.vprops_begin(), mesh.vprops_end(), properties_.begin(), properties_.end());
}

void VertexProperties::merge(OpenMesh::TriConnectivity& mesh, VertexHandle survivor, VertexHandle removed,
                             const Vec3& position, const PositionOf& position_of) const {
  Ring ring = ring_of(mesh, survivor, removed, position_of);
  add_to(ring.mesh, mesh, ring.handles);
  const Frame frame = Frame::of_points(ring.mesh.positions);
  std::vector<Index> map(ring.handles.size(), invalid_index);
  map[0] = map[1] = 0;
  const LocalFunctions functions(ring.mesh, frame, map, 1, 1);
  const double share = nearest_share(position, ring.mesh.positions[0], ring.mesh.positions[1]);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Attribute& around = ring.mesh.attributes[i];
    AttributeBlend mean(around.kind, around.n_components);
    mean.add(around.value(0), 1 - share);
    mean.add(around.value(1), share);
    std::vector<double> value(around.n_components);
    if (!mean.result(value)) continue;
    if (position != ring.mesh.positions[1]) {
      AttributeFunctions(functions, around.kind, around.n_components, around.values, 1)
          .move(0, frame.to_frame(position), value);
    }
    columns_[i]->set(mesh, survivor, value);
  }
}

void VertexProperties::add_to(IndexedMesh& to, const OpenMesh::BaseKernel& mesh,
                              const std::vector<Index>& handles) const {
  for (const auto& column : columns_) {
    Attribute attribute = column->attribute();
    const std::size_t n = attribute.n_components;
    attribute.values.resize(n * handles.size());
    for (std::size_t v = 0; v < handles.size(); ++v) {
      column->get(mesh, VertexHandle(static_cast<int>(handles[v])), std::span(attribute.values).subspan(n * v, n));
    }
    to.attributes.push_back(std::move(attribute));
  }
}

void VertexProperties::set(const IndexedMesh& from, Index v, OpenMesh::BaseKernel& mesh, VertexHandle to) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i]->set(mesh, to, from.attributes[i].value(v));
}

}  // namespace whittle
