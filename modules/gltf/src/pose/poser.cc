#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "asset_content.hh"
#include "document/json.hh"
#include "geometry/instances.hh"
#include "model/model.hh"
#include "pose/animation.hh"
#include "pose/artificial.hh"
#include "pose/posable_mesh.hh"
#include "pose/rig.hh"
#include "whittle/gltf/pose.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

/// Nodes and instances can repeat a mesh without end. A scene of this size takes 5 GB.
constexpr std::size_t largest_scene = std::size_t{1} << 27;

std::size_t n_targets_of(const Mesh& mesh) {
  std::size_t n = 0;
  for (const Primitive& primitive : mesh.primitives) {
    if (primitive.is_surface()) n = std::max(n, primitive.targets.size());
  }
  return n;
}

/// Appends positions and faces of a mesh.
void append(std::span<const Vec3> positions, std::span<const Triangle> faces, IndexedMesh& scene) {
  const auto first = static_cast<Index>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), positions.begin(), positions.end());
  for (Triangle face : faces) {
    for (Index& v : face) v += first;
    scene.faces.push_back(face);
  }
}

}  // namespace

struct Poser::Content {
  /// A mesh in the scene.
  struct Placed {
    std::size_t mesh = 0;
    std::optional<std::size_t> node;         ///< none: no node of the asset has a mesh
    std::optional<std::size_t> skin;         ///< set if its vertices have joints
    std::vector<Eigen::Matrix4d> instances;  ///< from the mesh to the node; one if it has a skin
  };

  /// Matrices of a pose.
  struct Posed {
    std::vector<Eigen::Matrix4d> worlds;               ///< of each node, to the scene's coordinates
    std::vector<std::vector<Eigen::Matrix4d>> joints;  ///< of each skin, of each joint: from the mesh's to the scene's
  };

  const Model& model;
  Rig rig;
  std::vector<PosableMesh> meshes;  // by their numbers; empty outside of the scene
  std::vector<std::size_t> n_targets;
  std::vector<Animation> animations;
  std::vector<Placed> scene;

  Content(const Model& of, const Part& root) : model(of), rig(read_rig(of, root)) {
    for (const Mesh& mesh : model.meshes) n_targets.push_back(n_targets_of(mesh));
    animations = read_animations(model, root, n_targets);
  }

  void place_nodes(const Asset& asset) {
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
      const Node& node = model.nodes[n];
      if (!node.mesh || !node.is_shown || asset.n_triangles(*node.mesh) == 0) continue;
      std::vector<Eigen::Matrix4d> instances = instance_matrices(model, node);
      if (!instances.empty()) scene.push_back({*node.mesh, n, rig.skin_of_node[n], std::move(instances)});
    }
    if (!scene.empty()) return;
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
      if (asset.n_triangles(m) > 0) scene.push_back({m, {}, {}, {Eigen::Matrix4d::Identity()}});
    }
  }

  /// Reads the meshes of the scene, and looks up whether they have joints.
  void read_meshes(const Asset& asset) {
    meshes.resize(model.meshes.size());
    for (Placed& placed : scene) {
      PosableMesh& mesh = meshes[placed.mesh];
      const std::string what = "mesh " + std::to_string(placed.mesh);
      if (mesh.faces.empty()) mesh = posable_mesh(asset.triangles(placed.mesh), what, model.file);
      if (mesh.n_joints == 0) placed.skin.reset();
      if (!placed.skin) continue;
      placed.instances.resize(1);
      const std::size_t n_joints = rig.skins[*placed.skin].joints.size();
      if (mesh.n_joints > n_joints) {
        throw io::ReadError(model.file, what + ": joint " + std::to_string(mesh.n_joints - 1) + " is above the " +
                                            std::to_string(n_joints) + " joints of skin " +
                                            std::to_string(*placed.skin));
      }
    }
  }

  void check_size() const {
    std::size_t n = 0;  // each step adds less than 2^32 times the instances, which have matrices in memory
    for (const Placed& placed : scene) {
      const PosableMesh& mesh = meshes[placed.mesh];
      n += placed.instances.size() * std::max(mesh.positions.size(), mesh.faces.size());
      if (n > largest_scene) {
        throw io::ReadError(model.file, "the scene has more than 2^27 vertices or triangles, too many to be posed");
      }
    }
  }

  Posed posed(const Pose& pose) const {
    Posed posed{world_matrices(model, pose.nodes), {}};
    for (const Skin& skin : rig.skins) {
      std::vector<Eigen::Matrix4d>& joints = posed.joints.emplace_back();
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        joints.push_back(posed.worlds[skin.joints[j]] * skin.inverse_bind[j]);
      }
    }
    return posed;
  }

  void append_placed(const Placed& placed, const Pose& pose, const Posed& posed, IndexedMesh& to) const {
    const PosableMesh& mesh = meshes[placed.mesh];
    const std::vector<Vec3> still = placed.node ? apply_targets(mesh, pose.weights[*placed.node]) : mesh.positions;
    for (const Eigen::Matrix4d& instance : placed.instances) {
      const Eigen::Matrix4d matrix = placed.node ? posed.worlds[*placed.node] * instance : instance;
      std::vector<Vec3> positions = still;
      if (placed.skin) {
        apply_skin(mesh, posed.joints[*placed.skin], matrix, positions);
      } else {
        apply_matrix(positions, matrix);
      }
      for (const Vec3& p : positions) {
        if ((p.array().abs() <= largest_coordinate).all()) continue;
        throw io::ReadError(model.file,
                            "mesh " + std::to_string(placed.mesh) + ": a position of its pose is not finite");
      }
      append(positions, mesh.faces, to);
    }
  }
};

Poser::Poser(const Asset& asset)
    : content_(std::make_unique<Content>(asset.content_->model,
                                         Part(asset.content_->document, "", asset.content_->model.file))) {
  content_->place_nodes(asset);
  content_->read_meshes(asset);
  content_->check_size();
}

Poser::Poser(Poser&& other) noexcept = default;
Poser& Poser::operator=(Poser&& other) noexcept = default;
Poser::~Poser() = default;

std::size_t Poser::n_nodes() const { return content_->model.nodes.size(); }

bool Poser::has_skins() const {
  const std::vector<Content::Placed>& scene = content_->scene;
  return std::any_of(scene.begin(), scene.end(), [](const Content::Placed& placed) { return placed.skin.has_value(); });
}

bool Poser::has_morph_targets() const {
  const std::vector<Content::Placed>& scene = content_->scene;
  return std::any_of(scene.begin(), scene.end(), [&](const Content::Placed& placed) {
    return placed.node && !content_->meshes[placed.mesh].displacements.empty();
  });
}

std::size_t Poser::n_animations() const { return content_->animations.size(); }

bool Poser::is_animated() const {
  const std::vector<Animation>& animations = content_->animations;
  return std::any_of(animations.begin(), animations.end(), [](const Animation& a) { return !a.tracks.empty(); });
}

std::string Poser::animation_name(std::size_t animation) const { return content_->animations.at(animation).name; }

std::vector<AnimationTime> Poser::moments(std::size_t n) const { return gltf::moments(content_->animations, n); }

Pose Poser::rest() const { return {local_matrices(content_->model), content_->rig.weights_of_node}; }

Pose Poser::animated(const AnimationTime& moment) const {
  const Animation& animation = content_->animations.at(moment.animation);
  Pose pose = rest();
  animate(content_->model, animation, moment.seconds, pose);
  return pose;
}

Pose Poser::artificial(std::size_t number) const {
  Pose pose = rest();
  std::set<std::size_t> joints;
  for (const Skin& skin : content_->rig.skins) joints.insert(skin.joints.begin(), skin.joints.end());
  for (const std::size_t joint : joints) turn_joint(pose, joint, number);
  for (const Content::Placed& placed : content_->scene) {
    if (!placed.node) continue;
    const std::size_t n_targets = content_->n_targets[placed.mesh];
    pose.weights[*placed.node] = artificial_weights(*placed.node, n_targets, number);
  }
  return pose;
}

IndexedMesh Poser::mesh(const Pose& pose) const {
  if (pose.nodes.size() != n_nodes() || pose.weights.size() != n_nodes()) {
    throw std::invalid_argument("a pose of " + std::to_string(pose.nodes.size()) + " nodes for an asset of " +
                                std::to_string(n_nodes()));
  }
  const Content::Posed posed = content_->posed(pose);
  IndexedMesh scene;
  for (const Content::Placed& placed : content_->scene) content_->append_placed(placed, pose, posed, scene);
  return scene;
}

}  // namespace whittle::gltf
