#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <type_traits>

namespace whittle {

/// Direct access to the status bits of all elements of one kind, for loops over many of them. (`mesh.status(handle)`
/// looks the property up each time.) Valid until the mesh gains or loses elements or the property.
/// \tparam Kernel OpenMesh::ArrayKernel, or const: the base of all meshes
template <class Handle, class Kernel = OpenMesh::ArrayKernel>
class StatusBits {
 public:
  using Bits = OpenMesh::Attributes::StatusInfo;

  explicit StatusBits(Kernel& mesh) {
    const auto property = mesh.status_pph(Handle());
    if (property.is_valid()) first_ = mesh.property(property).data_vector().data();
  }

  /// Whether the mesh has the property.
  explicit operator bool() const { return first_ != nullptr; }
  auto& operator[](Handle handle) const { return first_[handle.idx()]; }
  /// False where the mesh has no status bits.
  bool is_deleted(Handle handle) const { return first_ != nullptr && first_[handle.idx()].deleted(); }

 private:
  std::conditional_t<std::is_const_v<Kernel>, const Bits, Bits>* first_ = nullptr;
};

/// The same, to read.
template <class Handle>
using ConstStatusBits = StatusBits<Handle, const OpenMesh::ArrayKernel>;

}  // namespace whittle
