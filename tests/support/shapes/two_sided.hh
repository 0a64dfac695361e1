#pragma once

#include <cstddef>
#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

/// Each of the first `count` faces once more at the end, turned over: a sheet with two sides. Attributes are dropped.
IndexedMesh with_backs(const IndexedMesh& mesh, std::size_t count);
/// The same with all faces.
IndexedMesh with_backs(const IndexedMesh& mesh);

}  // namespace whittle::test
