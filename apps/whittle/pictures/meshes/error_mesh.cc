#include "pictures/meshes/error_mesh.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle::app {
namespace {

/// Cuts faces in rounds until their edges look short.
class FaceCutter {
 public:
  FaceCutter(ValueMesh& out, const SeenLength& seen_length, double most_pixels)
      : out_(out), seen_length_(seen_length), most_pixels_(most_pixels) {}

  void cut() {
    std::vector<Triangle> open = std::exchange(out_.mesh.faces, {});
    for (int round = 0; round < most_rounds && !open.empty(); ++round) open = cut_round(open);
    out_.mesh.faces.insert(out_.mesh.faces.end(), open.begin(), open.end());
  }

 private:
  static constexpr int most_rounds = 16;

  /// \return the parts of the faces that are cut; the others are done
  std::vector<Triangle> cut_round(const std::vector<Triangle>& open) {
    middles_.clear();
    std::vector<Triangle> parts;
    for (const Triangle& face : open) {
      std::array<Index, 3> middle{};
      for (std::size_t k = 0; k < 3; ++k) middle[k] = middle_of(face[k], face[(k + 1) % 3]);
      add_parts(face, middle, parts);
    }
    return parts;
  }

  /// `invalid_index` for a short edge.
  Index middle_of(Index a, Index b) {
    const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32U | std::max(a, b);
    const auto [known, is_new] = middles_.try_emplace(key, invalid_index);
    if (!is_new) return known->second;
    std::vector<Vec3>& positions = out_.mesh.positions;
    if (!(seen_length_(positions[std::min(a, b)], positions[std::max(a, b)]) > most_pixels_)) return invalid_index;
    known->second = static_cast<Index>(positions.size());
    positions.emplace_back((positions[a] + positions[b]) / 2);
    out_.values.push_back((out_.values[a] + out_.values[b]) / 2);
    return known->second;
  }

  void add_parts(const Triangle& face, const std::array<Index, 3>& middle, std::vector<Triangle>& parts) {
    const auto n_cut = 3 - std::count(middle.begin(), middle.end(), invalid_index);
    if (n_cut == 0) {
      out_.mesh.faces.push_back(face);
      return;
    }
    std::size_t i = 0;
    while (n_cut == 1 && middle[i] == invalid_index) ++i;
    while (n_cut == 2 && middle[(i + 2) % 3] != invalid_index) ++i;
    const auto [a, b, c] = std::array{face[i], face[(i + 1) % 3], face[(i + 2) % 3]};
    const auto [ab, bc, ca] = std::array{middle[i], middle[(i + 1) % 3], middle[(i + 2) % 3]};
    if (n_cut == 1) parts.insert(parts.end(), {{a, ab, c}, {ab, b, c}});
    if (n_cut == 2) parts.insert(parts.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    if (n_cut == 3) parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}});
  }

  ValueMesh& out_;
  const SeenLength& seen_length_;
  double most_pixels_;
  std::unordered_map<std::uint64_t, Index> middles_;
};

}  // namespace

ValueMesh exact_distances(const ShownDistances& distances, const IndexedMesh& other, const SeenLength& seen_length,
                          double most_pixels, unsigned threads) {
  ValueMesh out{distances.mesh, distances.signed_distances};
  const std::size_t n_known = out.values.size();
  FaceCutter(out, seen_length, most_pixels).cut();
  if (out.values.size() == n_known) return out;
  const TriangleTree tree(other);
  for_each_range(out.values.size() - n_known, threads, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    for (std::size_t v = n_known + begin; v < n_known + end; ++v) {
      const ClosestPoint closest = tree.nearest(out.mesh.positions[v], hint);
      hint = closest.face;
      out.values[v] = std::copysign(std::sqrt(closest.distance_sq), out.values[v]);
    }
  });
  return out;
}

}  // namespace whittle::app
