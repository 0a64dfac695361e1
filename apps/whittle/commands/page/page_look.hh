#pragma once

#include <memory>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/engine/run_steps.hh"
#include "whittle/report/page.hh"

namespace whittle::app {

/// How a mesh file looks: the materials of its groups of faces (`read_materials`), and where the scene of a glTF file
/// puts its meshes. It holds no mesh.
class PageLook {
 public:
  PageLook() = default;
  /// \param input that was read \param warnings gets a line for each image that can't be read
  PageLook(const Input& input, std::vector<std::string>& warnings);

  /// Gives a surface its materials. \pre its groups are those of the input
  void dress(report::PageSurface& surface) const;

  /// Moves meshes to where the scene shows them first. Those that no node uses stay where they are.
  /// \param mesh of the groups of the input
  void put_in_scene(IndexedMesh& mesh) const;
  /// Likewise all positions of a run. \param input of the run, not moved
  void put_in_scene(const IndexedMesh& input, RunSteps& steps) const;

 private:
  void read_places(const GltfFile& file);
  std::vector<Index> groups_of_vertices(const IndexedMesh& mesh) const;
  bool is_mirrored(Index group) const { return places_[group].linear().determinant() < 0; }

  std::vector<report::PageMaterial> materials_;  ///< by group
  std::vector<Eigen::Affine3d> places_;          ///< by group, into the scene; empty if nothing is to be moved
  report::PageColors colors_ = report::PageColors::srgb;
};

}  // namespace whittle::app
