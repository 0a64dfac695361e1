#pragma once

#include <nanobind/nanobind.h>

#include <optional>

#include "arrays.hh"
#include "whittle/scene/scene.hh"

namespace whittle::python {

/// What Python has of a mesh: a scene, and the mesh that takes the place of its own, if it was simplified.
struct Mesh {
  Scene scene;
  std::optional<IndexedMesh> replaced{};
  bool is_float32 = false;  ///< whether points are told in single precision, as they were given

  const IndexedMesh& mesh() const { return replaced ? *replaced : scene.read.mesh; }
  IndexedMesh& mesh() { return replaced ? *replaced : scene.read.mesh; }
};

/// What is simplified: the mesh's scene, with the mesh that took the place of its own as if it had been given.
/// \param is_used_up whether the mesh isn't needed any more
Scene scene_to_simplify(Mesh& mesh, bool is_used_up);

/// −1 for `invalid_index`.
std::vector<std::int64_t> signed_numbers(std::span<const Index> numbers);

void bind_mesh(nb::module_& module);

}  // namespace whittle::python
