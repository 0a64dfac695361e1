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

/// Transforms and weights of a pose.
struct Pose {
  std::vector<Eigen::Matrix4d> nodes;        ///< per node, to its parent's coordinates
  std::vector<std::vector<double>> weights;  ///< per node, of its mesh's morph targets; absent ones are 0
};

/// A moment of an animation.
struct AnimationTime {
  std::size_t animation = 0;  ///< its number in the file
  double seconds = 0;
};

/// Poses the scene of an asset.
///
/// The scene has all shown nodes (`Asset::n_instances`) with meshes that have triangles. At rest, meshes without skins
/// and morph targets are placed by `Asset::world_transforms`. If the scene shows no mesh, it has each mesh once, in its
/// own coordinates.
class Poser {
 public:
  /// Reads geometry, skins and animations.
  /// \param asset must outlive the poser, and not change
  /// \throw io::ReadError as `Asset::triangles`; if a part of a skin or animation is missing, has the wrong type, or
  ///        isn't finite; if the scene has more than 2^27 vertices or triangles
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
  /// The name, or "animation N". One line of printable characters.
  std::string animation_name(std::size_t animation) const;
  /// `n` moments, spread evenly over all animations in turn: each in the middle of an nth of their time. If all
  /// durations are 0, animations get equal numbers of moments. \pre `is_animated`
  std::vector<AnimationTime> moments(std::size_t n) const;

  /// The pose of the document, without animation.
  Pose rest() const;
  /// A pose of one animation; nodes that it doesn't move are as in `rest`. Before its first time, and after its last
  /// time, it stands still. \throw std::out_of_range for an unknown animation
  Pose animated(const AnimationTime& moment) const;
  /// A pose for assets without animations: from `rest`, each joint turns about its origin by up to 30 degrees, and each
  /// morph target has a weight in [0, 1].
  /// \param number any; each gives another pose, the same for assets with equal nodes and skins
  Pose artificial(std::size_t number) const;

  /// The scene: positions in its coordinates, and faces, without attributes. Vertices aren't joined. All poses have the
  /// same vertices and faces in the same order.
  /// \throw std::invalid_argument if the pose doesn't have `n_nodes` nodes
  /// \throw io::ReadError if a position isn't finite, or is beyond 2^500
  IndexedMesh mesh(const Pose& pose) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace whittle::gltf
