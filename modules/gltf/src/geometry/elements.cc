#include "geometry/elements.hh"

#include <algorithm>

namespace whittle::gltf {
Elements::Elements(const Accessor& accessor) : accessor_(accessor) {
  if (!accessor.sparse) return;
  const SparseValues& sparse = *accessor.sparse;
  replaced_.reserve(sparse.count);
  for (std::size_t k = 0; k < sparse.count; ++k) {
    replaced_.emplace_back(load_whole(sparse.indices.data() + k * size_of(sparse.index_type), sparse.index_type), k);
  }
  std::stable_sort(replaced_.begin(), replaced_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

const char* Elements::bytes_of(std::size_t i) const {
  if (!replaced_.empty()) {
    const auto found = std::lower_bound(replaced_.begin(), replaced_.end(), std::pair(i, std::size_t{0}));
    if (found != replaced_.end() && found->first == i) {
      return accessor_.sparse->values.data() + found->second * accessor_.shape.packed_stride(accessor_.type);
    }
  }
  return accessor_.bytes.empty() ? nullptr : accessor_.bytes.data() + i * accessor_.stride;
}

void Elements::read(std::size_t i, std::span<double> components) const {
  const char* const bytes = bytes_of(i);
  const ElementShape& shape = accessor_.shape;
  const std::size_t n = std::min(components.size(), shape.n_components());
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at =
        k / shape.n_rows * shape.column_stride(accessor_.type) + k % shape.n_rows * size_of(accessor_.type);
    components[k] = bytes ? load_real(bytes + at, accessor_.type, accessor_.is_normalized) : 0;
  }
}

std::size_t Elements::whole(std::size_t i) const {
  const char* const bytes = bytes_of(i);
  return bytes ? load_whole(bytes, accessor_.type) : 0;
}

}  // namespace whittle::gltf
