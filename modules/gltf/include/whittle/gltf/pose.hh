#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/gltf/asset.hh"

// The scene of an asset in a pose: its nodes moved, its morph targets blended, its skins bent. glTF 2.0,
// sections 3.7.2.2 (morph targets), 3.7.3 (skins), 3.11 and appendix C (animations).
//
//   position = world(node) * (p + sum_t weight_t * displacement_t)                                   without a skin
//   position = sum_j weight_j * world(joint_j) * inverse_bind_j * (p + sum_t ...)  /  sum_j weight_j  with a skin

namespace whittle::gltf {

/// What is different from one pose to the next.
struct Pose {
  std::vector<Eigen::Matrix4d> nodes;        ///< of each node, to its parent's coordinates
  std::vector<std::vector<double>> weights;  ///< of each node, of its mesh's morph targets; absent ones are 0
};

/// A moment of an animation.
struct AnimationTime {
  std::size_t animation = 0;  ///< its number in the file
  double seconds = 0;
};

/// Poses the scene of an asset.
///
/// The scene has all nodes that are shown (`Asset::n_instances`), with meshes that have triangles. At rest, those
/// without skins and morph targets are where `Asset::world_transforms` places them. Where none is shown, it has each
/// mesh once, where its own coordinates put it.
class Poser {
 public:
  /// Reads geometry, skins and animations. \param asset must outlive the poser, and stay as it is
  /// \throw io::ReadError as `Asset::triangles`, or if something of a skin or an animation isn't there, has the wrong
  ///        type, or isn't finite; if the scene has more than 2^27 vertices or triangles
  explicit Poser(const Asset& asset);
  Poser(Poser&& other) noexcept;
  Poser& operator=(Poser&& other) noexcept;
  ~Poser();

  std::size_t n_nodes() const;
  /// Whether the scene has a mesh whose vertices have joints, in a node with a skin.
  bool has_skins() const;
  /// Whether the scene has a mesh with a morph target that moves positions.
  bool has_morph_targets() const;

  std::size_t n_animations() const;
  /// Whether an animation moves, turns or scales a node, or blends morph targets.
  bool is_animated() const;
  /// The name, or "animation N" if there is none. One line of printable characters.
  std::string animation_name(std::size_t animation) const;
  /// From the first time to the last one of an animation, seconds, [0, inf).
  double duration(std::size_t animation) const;
  /// `n` moments, spread evenly over all animations one after the other: each in the middle of an nth of their time.
  /// Where no animation takes time, each gets its share of them. \pre `is_animated`
  std::vector<AnimationTime> moments(std::size_t n) const;

  /// As the document has it, without animation.
  Pose rest() const;
  /// Of one animation; what it doesn't move is as in `rest`. Before its first time, and after its last one, it stands
  /// still. \throw std::out_of_range if there is no such animation
  Pose animated(const AnimationTime& moment) const;
  /// For assets without animations. From `rest`, each joint is turned about its own origin by an angle of up to 30
  /// degrees, and each morph target has a weight in [0, 1]. \param number of the pose, any; each gives another pose,
  /// the same for assets with the same nodes and skins
  Pose artificial(std::size_t number) const;

  /// The scene: positions in its coordinates, and faces, without attributes. Vertices aren't joined. For all poses the
  /// same vertices and faces in the same order.
  /// \throw std::invalid_argument if the pose isn't one of `n_nodes` nodes
  /// \throw io::ReadError if a position isn't finite, or is beyond 2^500
  IndexedMesh mesh(const Pose& pose) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace whittle::gltf
