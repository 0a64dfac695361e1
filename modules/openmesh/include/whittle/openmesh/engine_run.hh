#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/bulk_collapse.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/face_relinker.hh"
#include "whittle/openmesh/status_bits.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// One call of `decimate` with the engine driver: `whittle::decimate` on a copy of the geometry, in which copies of a
/// vertex are one, then the same contractions on the mesh, all at once.
template <class MeshT>
class EngineRunT {
 public:
  /// \param target effective: with the cost module's limit
  EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using Copy = typename FaceRelinkerT<MeshT>::Copy;
  struct Shape {
    std::size_t n_further_fans;  ///< beside the first of each vertex
    std::ptrdiff_t euler_number;
    bool operator==(const Shape&) const = default;
  };

  std::vector<VertexPair> find_features() const;
  std::vector<std::uint8_t> fixed_vertices(bool only_selected) const;
  Decimation contract();
  Decimation contract_again(DecimateOptions options) const;
  static std::uint64_t count_vertices(const IndexedMesh& mesh);

  void write_back(Decimation& small);
  bool are_collapses(const Decimation& small) const;
  static Shape shape_of(const IndexedMesh& mesh);
  std::vector<Copy> relink(const Decimation& small);
  std::vector<Copy> collapse(const Decimation& small);
  void update_face_normals(const std::vector<Copy>& vertices, const std::vector<Index>& origins);
  void hand_over_quadrics(const std::vector<Copy>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses);

  Index handle_index(Index v) const { return numbers_.handles[v]; }
  Index number(VertexHandle v) const { return numbers_.number_of[static_cast<std::size_t>(v.idx())]; }
  VertexHandle handle(Index v) const { return VertexHandle(static_cast<int>(handle_index(v))); }

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  DecimateTarget target_;
  detail::VertexNumbers numbers_;
  IndexedMesh input_;
  std::vector<VertexPair> features_;  ///< edges, in the engine's numbers
  std::vector<std::uint8_t> locked_;
  std::vector<VertexMerge> merges_;  ///< by first copies
};

}  // namespace whittle

#include "whittle/openmesh/engine_run_impl.hh"
