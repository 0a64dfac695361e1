#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// NumPy arrays and meshes.

namespace whittle::python {

namespace nb = nanobind;

/// An array that is read, of any type that NumPy has numbers of, in C order.
using Array = nb::ndarray<nb::ro, nb::c_contig, nb::device::cpu>;
/// An array that is given to Python.
template <class T>
using NewArray = nb::ndarray<nb::numpy, T, nb::c_contig>;

/// An attribute as Python has it.
struct NamedArray {
  std::string name;
  std::string kind;  ///< "normal" and "color", which are those of the mesh, "texcoord", or "number"
  Array values;      ///< (V,) or (V, k); with a value for each corner (3F,) or (3F, k)
};

/// \param points (V, 3), float32 or float64 \param faces (F, 3), int32, int64, uint32 or uint64
/// \throw std::invalid_argument for another shape, for a number that isn't finite, or a vertex that isn't there
IndexedMesh mesh_of(const Array& points, const Array& faces);
/// \throw std::invalid_argument for another length or number of columns
void add_attributes(const std::vector<NamedArray>& arrays, IndexedMesh& mesh);
/// The numbers of an array, whatever their type.
std::vector<double> numbers(const Array& array);
/// \throw std::invalid_argument for a number that is no `Index`
std::vector<Index> indices(const Array& array);

/// A view of numbers that `owner` has, and that may be written to. \param n_columns 0: the array has one dimension
template <class T>
nb::object view(T* numbers, std::size_t n_rows, std::size_t n_columns, nb::handle owner) {
  const std::size_t shape[2] = {n_rows, n_columns};
  return nb::cast(NewArray<T>(numbers, n_columns == 0 ? 1 : 2, shape, owner));
}
/// An array of its own.
template <class T>
nb::object array_of(std::vector<T> numbers) {
  auto* const kept = new std::vector<T>(std::move(numbers));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  const std::size_t n = kept->size();
  return nb::cast(NewArray<T>(kept->data(), 1, &n, owner));
}

}  // namespace whittle::python
