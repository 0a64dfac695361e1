#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/render/scene.hh"

namespace whittle::bake {

/// An image on one mesh, in linear light.
class LinearTexture {
 public:
  /// \param pixels must outlive the texture
  LinearTexture(const Texture& texture, const render::Pixels& pixels, const Attribute& texcoords);

  const Attribute& texcoords() const { return *texcoords_; }
  /// Bilinear. \param at texture coordinates as in the attribute
  Vec3 at(const Eigen::Vector2d& at) const;
  /// Texels that a triangle covers. \param corners texture coordinates as in the attribute
  double texels(const std::array<Eigen::Vector2d, 3>& corners) const;

 private:
  Vec3 texel(double column, double row) const;

  Eigen::Affine2d transform_;
  std::array<Wrap, 2> wrap_;
  const render::Pixels* pixels_;
  const Attribute* texcoords_;
};

/// A place on a surface.
struct Place {
  std::size_t face;
  Barycentric at;
  double distance;      ///< from the point that it was looked up for
  bool faces_same_way;  ///< and is within reach
};

/// The faces of a scene, with what they look like. Faces of all parts are numbered through.
class Look {
 public:
  /// \param scene must outlive the object \param reach_rel a share of the diagonal
  Look(const render::Scene& scene, double reach_rel);

  /// \param normal of the surface at the point, any length
  /// \param near a distance in which there probably is a place; only the time depends on it
  Place nearest(const Vec3& point, const Vec3& normal, double near) const;
  /// Base colour, linear, [0, 1].
  Vec3 color(const Place& place) const;
  /// Unit length, or zero if the surface has none there.
  Vec3 normal(const Place& place) const;

  std::size_t n_faces() const { return all_.faces.size(); }
  /// Texels on all faces; the number of faces if that is more.
  double texels() const;

 private:
  struct Group {
    Vec3 factor;
    std::optional<LinearTexture> texture;
  };
  struct Part {
    IndexedMesh mesh;
    std::vector<std::array<float, 3>> normals;  ///< of vertices, if the mesh has none
    std::vector<Group> groups;                  ///< and one without a material
    std::size_t first_face;
    bool has_srgb_colors;
  };
  struct PartFace {
    const Part* part;
    std::size_t face;  ///< of the part
  };

  void add(const render::Scene& scene, const render::Part& part);
  PartFace find(std::size_t face) const;
  static const Group& group_of(const PartFace& own);

  std::vector<Part> parts_;
  IndexedMesh all_;
  std::vector<Vec3> area_normals_;  ///< Per face.
  std::optional<TriangleTree> tree_;
  double reach_ = 0;
};

}  // namespace whittle::bake
