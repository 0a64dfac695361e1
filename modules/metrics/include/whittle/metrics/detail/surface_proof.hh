#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/proof/prover.hh"
#include "whittle/core/geometry/proof/target_surface.hh"

namespace whittle::metrics {

/// Proves, after each change, that a surface and its original are within a distance of each other, at every point.
///
///   - Each face of the surface is proven to be near to the original.
/// - Each face of the original *rests on* faces of the surface: it is proven to be near these alone. So the proof
///     holds until one of them changes.
///
/// A change proves the new faces, and again the faces that rested on the old ones.
class SurfaceProof {
 public:
  /// A face of the surface by its vertices. Numbers of faces and vertices are free to choose: memory is taken for all
  /// numbers up to the highest. With two equal corners it is a segment.
  struct Face {
    Index number = invalid_index;
    Triangle vertices{};
  };

  /// A change of the surface by a contraction.
  struct Change {
    Index moved = invalid_index;   ///< vertex that moves, or `invalid_index`
    Vec3 position = Vec3::Zero();  ///< its new position, model units
    std::vector<Index> removed{};  ///< faces that vanish or change
    std::vector<Face> added{};     ///< faces that they become. `allows` doesn't read the numbers
    std::vector<Index> around{};   ///< other faces on which the original may rest
  };

  /// \param original must outlive the proof. Triangles with two equal corners are segments.
  /// \param limit model units, not negative
  SurfaceProof(const IndexedMesh& original, double limit);

  /// Begins with a surface, and tries to prove it. \param positions by vertex, model units
  void start(std::span<const Vec3> positions, std::span<const Face> faces);

  /// Whether all faces that the change affects are proven after it. The answer depends on the surface and the change
  /// alone, not on earlier calls. \pre `start`
  bool allows(const Change& change);
  /// Changes the surface, even if the proof fails. \pre `start`; each added face has a number
  void make(const Change& change);

  /// Whether all points of both surfaces are proven. \pre `start`
  bool is_proven() const { return n_unproven_ == 0; }

 private:
  struct SurfaceFace {
    Triangle vertices{};
    Index hint = invalid_index;  ///< face of the original that is likely near
    bool is_unproven = false;
    std::uint32_t removed_in = 0;  ///< last look in which it was removed
    std::uint32_t listed_in = 0;   ///< last look in which it was listed in `others_`
    std::vector<Index> resting{};  ///< faces of the original
  };
  struct OriginalFace {
    std::vector<Index> rests_on{};  ///< faces of the surface
    std::uint32_t look = 0;         ///< last look in which it was affected
    bool is_unproven = false;
  };
  /// The nearby face of a vertex of the original after a change.
  struct Nearby {
    std::uint32_t look = 0;
    Index added = 0;  ///< new face; or one of these:
    static constexpr Index other = invalid_index - 1;
    static constexpr Index nothing = invalid_index;
  };
  /// Some faces of the surface, as the target of proofs for faces of the original.
  struct Part {
    std::vector<Index> numbers;  ///< per face
    IndexedMesh mesh;            ///< in the frame
    std::optional<TargetSurface> surface;
    std::optional<Prover> prover;
  };

  SurfaceFace& face(Index number);
  void start_surface(std::span<const Face> faces);
  void start_original(std::span<const Face> faces);
  void rest_at_start(Index original_face, const std::vector<Index>& near, std::span<const Face> faces);

  void look_at(const Change& change);
  void list_affected();
  void list_others();
  bool is_position_near() const;
  std::optional<Index> hint_if_near(const Face& face);
  bool can_rest(Index original_face);
  bool is_any_corner_lost(Index original_face);
  Index nearby(Index original_vertex);
  Index find_nearby(const Vec3& point);
  std::optional<std::size_t> find_added_near(Index original_face);
  void make_part(std::span<const Face> faces);
  Part& part_after();
  bool is_near_part(Index original_face, Part& part) const;
  std::vector<Index> near_in_part(Index original_face, const Part& part) const;
  std::vector<Index> find_rest(Index original_face, bool& is_unproven);
  void set_rest(Index original_face, std::vector<Index> faces, bool is_unproven);
  void take_off(Index original_face);
  void remove(Index number);
  void set_unproven(bool& is_unproven, bool value);

  Vec3 position_after(Index v) const { return v == change_->moved ? position_ : positions_[v]; }
  Corners corners_after(const Triangle& face) const {
    return {position_after(face[0]), position_after(face[1]), position_after(face[2])};
  }
  Corners corners_of_original(Index face) const { return original_.faces().corners(face); }
  Index hint_for(const Face& face) const;

  Frame frame_;
  double limit_;  ///< in the frame
  TargetSurface original_;
  Prover prover_;                ///< of faces of the surface
  std::vector<Vec3> positions_;  ///< by vertex of the surface, in the frame
  std::vector<SurfaceFace> faces_;
  std::vector<OriginalFace> originals_;
  std::size_t n_unproven_ = 0;

  // State of the last look at a change.
  const Change* change_ = nullptr;
  Vec3 position_ = Vec3::Zero();  ///< in the frame
  std::vector<Corners> added_;
  std::size_t added_near_ = 0;   ///< last one found near
  std::vector<Index> affected_;  ///< faces of the original
  bool has_others_ = false;
  std::vector<Index> others_;  ///< faces around, and faces on which affected faces rest
  std::vector<Corners> others_corners_;
  std::vector<Nearby> nearby_;  ///< by vertex of the original
  bool has_part_ = false;
  Part part_;
  std::uint32_t n_looks_ = 0;
};

}  // namespace whittle::metrics
