#pragma once

#include <deque>
#include <memory>
#include <string>

#include "pictures/meshes/error_mesh.hh"
#include "pictures/meshes/scales.hh"
#include "pictures/meshes/shown_model.hh"
#include "whittle/render/figure.hh"

namespace whittle::app {

/// Where figures are seen, for colours that are exact there.
struct ExactColors {
  SeenLength seen_length;
  double most_pixels = 3;
  unsigned threads = 0;
};

/// Puts surfaces into a figure, as the page of `report` draws them.
class FigureMaker {
 public:
  /// \param colour what the view's colour is, after all \param top where the scale of errors ends
  FigureMaker(const PictureView& view, std::string colour, double top, ExactColors exact);

  void add(const ShownModel& model);
  /// In front of another surface.
  void add_ghost(const ShownModel& model);

  /// It has pointers to meshes that are here. \param warnings gets a line for each texture that can't be drawn
  const render::Figure& figure(std::vector<std::string>& warnings);

 private:
  render::Layer& add_layer(IndexedMesh mesh, std::vector<Material> materials);
  void add_faces(const ShownModel& model, double opacity);
  void add_plain(const ShownModel& model, double opacity);
  void add_look(const ShownModel& model, bool with_materials);
  void add_values(IndexedMesh mesh, const std::vector<double>& values, const ColorScale& scale, double top,
                  double opacity);
  void add_shapes(const ShownModel& model, double opacity);
  void add_normals(const ShownModel& model);
  void add_edges(const ShownModel& model);
  void add_borders(const ShownModel& model);
  void add_dots(const ShownModel& model);
  void add_valences(const ShownModel& model);
  void set_normals(IndexedMesh& mesh) const;
  Material scale_material(const ColorScale& scale, double opacity);

  const PictureView& view_;
  std::string colour_;
  double top_;
  ExactColors exact_;
  std::deque<IndexedMesh> meshes_;
  render::Figure figure_;
};

}  // namespace whittle::app
