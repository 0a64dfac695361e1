#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Mesh/Status.hh>
#include <type_traits>

namespace whittle {

/// Direct access to the status bits of all elements of one kind, for loops over many of them. (`mesh.status(handle)`
/// looks the property up each time.) Valid until the mesh gains or loses elements or the property.
template <class HandleT, class MeshT>
class StatusBitsT {
 public:
  using Bits = OpenMesh::Attributes::StatusInfo;

  explicit StatusBitsT(MeshT& mesh) {
    const auto property = mesh.status_pph(HandleT());
    if (property.is_valid()) first_ = mesh.property(property).data_vector().data();
  }

  /// Whether the mesh has the property.
  explicit operator bool() const { return first_ != nullptr; }
  auto& operator[](HandleT handle) const { return first_[handle.idx()]; }
  /// False where the mesh has no status bits.
  bool is_deleted(HandleT handle) const { return first_ != nullptr && first_[handle.idx()].deleted(); }

 private:
  std::conditional_t<std::is_const_v<MeshT>, const Bits, Bits>* first_ = nullptr;
};

}  // namespace whittle
