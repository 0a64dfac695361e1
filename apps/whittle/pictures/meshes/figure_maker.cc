#include "pictures/meshes/figure_maker.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/meshes/webp_image.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/wedges.hh"

namespace whittle::app {
namespace {

constexpr render::Rgb color_of_backs = rgb_of(0x8A5A44);
constexpr render::Rgb color_of_edges = rgb_of(0x202020);
constexpr render::Rgb color_of_borders = rgb_of(0xD55E00);
constexpr render::Rgb color_of_nonmanifold = rgb_of(0xCC0066);
constexpr double opacity_of_edges = 0.55;
constexpr double opacity_of_ghosts = 0.35;
constexpr char value_name[] = "TEXCOORD_0";

/// Positions, faces, wedges, and normals.
IndexedMesh bare(const IndexedMesh& mesh) {
  IndexedMesh out;
  out.positions = mesh.positions;
  out.faces = mesh.faces;
  out.wedges = mesh.wedges;
  out.normals = mesh.normals;
  return out;
}

/// A row of texels from the last colour to the first and back: the middle is 0.
render::Pixels pixels_of(const ColorScale& scale) {
  constexpr std::size_t n_texels = 1024;  // of each half: filters blur a step's ends by a hundredth
  render::Pixels pixels{2 * n_texels, 1, {}};
  pixels.rgba.resize(4 * pixels.width);
  for (std::size_t i = 0; i < pixels.width; ++i) {
    const std::size_t from_middle = i < n_texels ? n_texels - 1 - i : i - n_texels;
    const render::Rgb& color = scale.colors[from_middle * scale.colors.size() / n_texels];
    for (std::size_t k = 0; k < 3; ++k) {
      pixels.rgba[4 * i + k] = static_cast<std::uint8_t>(std::lround(color[k] * 255));
    }
    pixels.rgba[4 * i + 3] = 255;
  }
  return pixels;
}

/// Adds the images of a part that are WebP.
void decode_webp(const render::Part& part, std::map<std::shared_ptr<const Image>, render::Pixels>& images) {
  for (const Material& material : part.materials) {
    if (!material.base_color_texture) continue;
    const std::shared_ptr<const Image>& image = material.base_color_texture->image;
    if (images.contains(image) || media_type(image->bytes) != "image/webp") continue;
    if (std::optional<render::Pixels> pixels = read_webp(image->bytes)) images.emplace(image, std::move(*pixels));
  }
}

/// The number of each vertex's edges; 0 without a face.
std::vector<std::size_t> valences(const IndexedMesh& mesh) {
  std::vector<std::size_t> counts(mesh.positions.size());
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    ++counts[edges[e].a];
    ++counts[edges[e].b];
  }
  return counts;
}

}  // namespace

FigureMaker::FigureMaker(const PictureView& view, std::string colour, double top, ExactColors exact)
    : view_(view), colour_(std::move(colour)), top_(top), exact_(std::move(exact)) {}

void FigureMaker::add(const ShownModel& model) {
  if (model.surface->mesh.faces.empty()) return;
  if (view_.faces) add_faces(model, 1);
  if (view_.edges) add_edges(model);
  if (colour_ == "valence") add_valences(model);
  if (!model.is_level) add_borders(model);
}

void FigureMaker::add_ghost(const ShownModel& model) {
  if (model.surface->mesh.faces.empty()) return;
  if (view_.ghost == "transparent") add_faces(model, opacity_of_ghosts);
  if (view_.ghost == "edges") add_edges(model);
  if (view_.ghost == "points") add_dots(model);
  add_borders(model);
}

const render::Figure& FigureMaker::figure(std::vector<std::string>& warnings) {
  render::Scene scene;
  for (const render::Layer& layer : figure_.layers) scene.parts.push_back(layer.part);
  scene.images = std::move(figure_.images);
  for (const render::Part& part : scene.parts) decode_webp(part, scene.images);
  for (std::string& problem : render::decode_images(scene)) {
    if (std::find(warnings.begin(), warnings.end(), problem) == warnings.end()) warnings.push_back(std::move(problem));
  }
  figure_.images = std::move(scene.images);
  return figure_;
}

render::Layer& FigureMaker::add_layer(IndexedMesh mesh, std::vector<Material> materials) {
  render::Layer& layer = figure_.layers.emplace_back();
  layer.part.mesh = &meshes_.emplace_back(std::move(mesh));
  layer.part.materials = std::move(materials);
  return layer;
}

/// \param opacity below 1 for a ghost, which shows no materials
void FigureMaker::add_faces(const ShownModel& model, double opacity) {
  const bool is_whole = opacity >= 1;
  const IndexedMesh& mesh = model.surface->mesh;
  if (is_whole && colour_ == "material" && model.has_materials()) return add_look(model, true);
  if (is_whole && colour_ == "colours" && model.has_colors()) return add_look(model, false);
  if (colour_ == "normals" && model.has_normals()) return add_normals(model);
  if (colour_ == "shape") return add_shapes(model, opacity);
  if (const ShownDeviations* const found = model.deviations(colour_)) {
    return add_values(bare(mesh), found->values, error_scale(), top_, opacity);
  }
  if (colour_ != "error" || !model.surface->distances) return add_plain(model, opacity);
  const ShownDistances& distances = *model.surface->distances;
  if (model.other == nullptr) {
    return add_values(distances.mesh, distances.signed_distances, error_scale(), top_, opacity);
  }
  ValueMesh exact = exact_distances(distances, *model.other, exact_.seen_length, exact_.most_pixels, exact_.threads);
  add_values(std::move(exact.mesh), exact.values, error_scale(), top_, opacity);
}

void FigureMaker::add_plain(const ShownModel& model, double opacity) {
  IndexedMesh mesh = bare(model.surface->mesh);
  set_normals(mesh);
  add_layer(std::move(mesh), {render::plain_material(model.color, opacity)}).back = color_of_backs;
}

void FigureMaker::add_look(const ShownModel& model, bool with_materials) {
  const ShownSurface& surface = *model.surface;
  IndexedMesh mesh = surface.mesh;
  set_normals(mesh);
  std::vector<Material> materials = with_materials ? surface.materials : std::vector<Material>{};
  materials.emplace_back();  // of other groups
  if (!with_materials) mesh.face_groups.clear();
  for (Material& material : materials) {
    material.double_sided = true;
    std::optional<Texture>& texture = material.base_color_texture;
    if (texture && media_type(texture->image->bytes).empty()) texture.reset();  // the page has said so
  }
  render::Layer& layer = add_layer(std::move(mesh), std::move(materials));
  layer.part.vertex_colors = surface.colors;
  layer.shade = render::Shade::soft;
}

/// \param values of wedges
void FigureMaker::add_values(IndexedMesh mesh, const std::vector<double>& values, const ColorScale& scale, double top,
                             double opacity) {
  Attribute& places = mesh.attributes.emplace_back(Attribute{value_name, AttributeKind::texcoord, 2});
  places.values.reserve(2 * values.size());
  for (const double value : values) {
    places.values.push_back(0.5 + 0.5 * std::clamp(top > 0 ? value / top : 0, -1.0, 1.0));
    places.values.push_back(0.5);
  }
  set_normals(mesh);
  add_layer(std::move(mesh), {scale_material(scale, opacity)}).shade = render::Shade::soft;
}

/// Each corner has a wedge of its own, with the face's value.
void FigureMaker::add_shapes(const ShownModel& model, double opacity) {
  IndexedMesh mesh = without_attributes(model.surface->mesh);
  const std::size_t n_corners = 3 * mesh.faces.size();
  mesh.wedges.resize(n_corners);
  std::vector<double> values(n_corners);
  for (std::size_t corner = 0; corner < n_corners; ++corner) {
    const Triangle& face = mesh.faces[corner / 3];
    mesh.wedges[corner] = static_cast<Index>(corner);
    values[corner] = corner % 3 > 0
                         ? values[corner - 1]
                         : radius_ratio(mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]);
  }
  add_values(std::move(mesh), values, shape_scale(), 1, opacity);
}

void FigureMaker::add_normals(const ShownModel& model) {
  IndexedMesh mesh = bare(model.surface->mesh);
  set_normals(mesh);
  add_layer(std::move(mesh), {render::plain_material({1, 1, 1})}).shade = render::Shade::normals;
}

void FigureMaker::add_edges(const ShownModel& model) {
  const IndexedMesh& mesh = model.surface->mesh;
  render::Lines lines{{}, color_of_edges, opacity_of_edges};
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  lines.ends.reserve(2 * edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    lines.ends.push_back(mesh.positions[edges[e].a]);
    lines.ends.push_back(mesh.positions[edges[e].b]);
  }
  figure_.lines.push_back(std::move(lines));
}

void FigureMaker::add_borders(const ShownModel& model) {
  const IndexedMesh& mesh = model.surface->mesh;
  render::Lines borders{{}, color_of_borders};
  render::Lines nonmanifold{{}, color_of_nonmanifold, 1, false};
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::size_t n = edges.sides(e).size();
    if (n == 2) continue;
    std::vector<Vec3>& ends = (n == 1 ? borders : nonmanifold).ends;
    ends.insert(ends.end(), {mesh.positions[edges[e].a], mesh.positions[edges[e].b]});
  }
  if (view_.borders) figure_.lines.push_back(std::move(borders));
  if (view_.nonmanifold) figure_.lines.push_back(std::move(nonmanifold));
}

/// Vertices with faces.
void FigureMaker::add_dots(const ShownModel& model) {
  constexpr double size = 2;
  const IndexedMesh& mesh = model.surface->mesh;
  render::Dots dots{{}, {model.color}, size};
  const std::vector<std::size_t> n_edges = valences(mesh);
  for (std::size_t v = 0; v < n_edges.size(); ++v) {
    if (n_edges[v] > 0) dots.places.push_back(mesh.positions[v]);
  }
  figure_.dots.push_back(std::move(dots));
}

void FigureMaker::add_valences(const ShownModel& model) {
  constexpr double size = 5;
  constexpr std::size_t least = 3;
  const IndexedMesh& mesh = model.surface->mesh;
  const std::vector<render::Rgb>& colors = valence_scale().colors;
  render::Dots dots{{}, {}, size};
  const std::vector<std::size_t> n_edges = valences(mesh);
  for (std::size_t v = 0; v < n_edges.size(); ++v) {
    if (n_edges[v] == 0) continue;
    dots.places.push_back(mesh.positions[v]);
    dots.colors.push_back(colors[std::min(std::max(n_edges[v], least) - least, colors.size() - 1)]);
  }
  figure_.dots.push_back(std::move(dots));
}

/// None, so that faces are flat; those of the file; or smooth ones.
void FigureMaker::set_normals(IndexedMesh& mesh) const {
  if (view_.shading == "file" && !mesh.normals.empty()) return;
  mesh.normals.clear();
  if (view_.shading == "flat") return;
  const std::vector<std::array<float, 3>> normals = vertex_normals(mesh, Frame::of_points(mesh.positions));
  if (mesh.wedges.empty()) {
    mesh.normals = normals;
    return;
  }
  mesh.normals.resize(n_wedges(mesh));
  for (std::size_t corner = 0; corner < mesh.wedges.size(); ++corner) {
    mesh.normals[mesh.wedges[corner]] = normals[mesh.faces[corner / 3][corner % 3]];
  }
}

Material FigureMaker::scale_material(const ColorScale& scale, double opacity) {
  Material material = render::plain_material({1, 1, 1}, opacity);
  Texture& texture = material.base_color_texture.emplace();
  texture.image = std::make_shared<const Image>();
  texture.texcoord = value_name;
  texture.wrap = {Wrap::clamp_to_edge, Wrap::clamp_to_edge};
  figure_.images.emplace(texture.image, pixels_of(scale));
  return material;
}

}  // namespace whittle::app
