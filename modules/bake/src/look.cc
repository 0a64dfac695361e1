#include "look.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/transform.hh"
#include "whittle/render/srgb.hh"

namespace whittle::bake {

namespace {

using detail::Vec2;

std::array<double, 256> lights_of_8_bits() {
  std::array<double, 256> lights{};
  for (std::size_t i = 0; i < lights.size(); ++i) lights[i] = render::linear_of_srgb(static_cast<double>(i) / 255);
  return lights;
}

/// The texel that shows at a whole coordinate; the first one for a number that isn't finite.
std::size_t wrapped(double at, std::size_t size, Wrap wrap) {
  const auto n = static_cast<double>(size);
  if (!std::isfinite(at)) return 0;
  if (wrap == Wrap::clamp_to_edge) return static_cast<std::size_t>(std::clamp(at, 0.0, n - 1));
  const double period = wrap == Wrap::repeat ? n : 2 * n;
  const double inside = at - period * std::floor(at / period);
  const double texel = inside < n ? inside : period - 1 - inside;
  return static_cast<std::size_t>(std::clamp(texel, 0.0, n - 1));
}

template <class Value>
auto blended(const Value& a, const Value& b, const Value& c, const Barycentric& at) {
  return ((1 - at.second - at.third) * a + at.second * b + at.third * c).eval();
}

Vec2 texcoord(const Attribute& texcoords, Index wedge) {
  const auto value = texcoords.value(wedge);
  return {value[0], value[1]};
}

std::array<Index, 3> wedges_of(const IndexedMesh& mesh, std::size_t face) {
  return {mesh.wedge(face, 0), mesh.wedge(face, 1), mesh.wedge(face, 2)};
}

Vec3 direction(const std::array<float, 3>& normal) { return {normal[0], normal[1], normal[2]}; }

Vec3 linear_color(const Color& color, bool is_srgb) {
  Vec3 light(color[0], color[1], color[2]);
  if (is_srgb) light = light.unaryExpr([](double value) { return render::linear_of_srgb(value); });
  return light;
}

}  // namespace

LinearTexture::LinearTexture(const Texture& texture, const render::Pixels& pixels, const Attribute& texcoords)
    : transform_(texture.transform), wrap_(texture.wrap), pixels_(&pixels), texcoords_(&texcoords) {}

Vec3 LinearTexture::texel(double column, double row) const {
  static const std::array<double, 256> lights = lights_of_8_bits();
  const std::size_t x = wrapped(column, pixels_->width, wrap_[0]);
  const std::size_t y = wrapped(row, pixels_->height, wrap_[1]);
  const std::uint8_t* const rgba = pixels_->rgba.data() + 4 * (y * pixels_->width + x);
  return {lights[rgba[0]], lights[rgba[1]], lights[rgba[2]]};
}

Vec3 LinearTexture::at(const Vec2& at) const {
  const Vec2 size(static_cast<double>(pixels_->width), static_cast<double>(pixels_->height));
  const Vec2 texels = (transform_ * at).cwiseProduct(size).array() - 0.5;
  const double column = std::floor(texels.x());
  const double row = std::floor(texels.y());
  const double x = texels.x() - column;
  const double y = texels.y() - row;
  const Vec3 upper = (1 - x) * texel(column, row) + x * texel(column + 1, row);
  const Vec3 lower = (1 - x) * texel(column, row + 1) + x * texel(column + 1, row + 1);
  return (1 - y) * upper + y * lower;
}

double LinearTexture::texels(const std::array<Vec2, 3>& corners) const {
  const double area = std::abs(detail::area_on_image(corners[0], corners[1], corners[2])) / 2;
  return area * std::abs(transform_.linear().determinant()) * static_cast<double>(pixels_->width) *
         static_cast<double>(pixels_->height);
}

Look::Look(const render::Scene& scene, double reach_rel) {
  parts_.reserve(scene.parts.size());
  for (const render::Part& part : scene.parts) add(scene, part);
  area_normals_.reserve(all_.faces.size());
  for (const Triangle& face : all_.faces) {
    area_normals_.push_back(reliable_normal(all_.positions[face[0]], all_.positions[face[1]], all_.positions[face[2]]));
  }
  tree_.emplace(all_);
  reach_ = reach_rel * diagonal_of(bounds_of(all_));
}

void Look::add(const render::Scene& scene, const render::Part& part) {
  Part& own =
      parts_.emplace_back(Part{*part.mesh, {}, {}, all_.faces.size(), part.vertex_colors == ColorEncoding::srgb});
  transform_mesh(own.mesh, part.transform);
  if (own.mesh.normals.empty()) own.normals = vertex_normals(own.mesh, Frame::of_points(own.mesh.positions));
  for (const Material& material : part.materials) {
    const std::array<double, 4> factor = base_color_factor(material);
    Group& group = own.groups.emplace_back(Group{{factor[0], factor[1], factor[2]}, std::nullopt});
    if (!material.base_color_texture) continue;
    const auto image = scene.images.find(material.base_color_texture->image);
    const Attribute* const texcoords = render::texcoords_of(own.mesh, *material.base_color_texture);
    if (image != scene.images.end() && texcoords != nullptr) {
      group.texture.emplace(*material.base_color_texture, image->second, *texcoords);
    }
  }
  own.groups.push_back({Vec3::Ones(), std::nullopt});
  const auto first = static_cast<Index>(all_.positions.size());
  all_.positions.insert(all_.positions.end(), own.mesh.positions.begin(), own.mesh.positions.end());
  for (const Triangle& face : own.mesh.faces) all_.faces.push_back({first + face[0], first + face[1], first + face[2]});
}

Place Look::nearest(const Vec3& point, const Vec3& normal, double near) const {
  const Vec3 offset = point - tree_->origin();
  ClosestPoint best;
  const auto search = [&](double reach) {
    tree_->visit_near(offset, reach * reach, [&](const ClosestPoint& closest) {
      const bool is_nearer = best.face == invalid_index || closest.distance_sq < best.distance_sq;
      if (is_nearer && area_normals_[closest.face].dot(normal) > 0) best = closest;
      return best.face == invalid_index ? reach * reach : best.distance_sq;
    });
  };
  search(std::min(near, reach_));
  if (best.face == invalid_index && near < reach_) search(reach_);
  const bool faces_same_way = best.face != invalid_index;
  if (!faces_same_way) {
    best = tree_->nearest_local(offset);
    best.point -= tree_->origin();
  }
  const auto [a, b, c] = corners_of(all_.positions, all_.faces[best.face]);
  const Vec3 p = best.point + tree_->origin();
  const Barycentric at = nearest_on_triangle(a - p, b - p, c - p);
  const bool is_point = !(std::isfinite(at.second) && std::isfinite(at.third));  // two corners are one
  return {best.face, is_point ? Barycentric{0, 0} : at, std::sqrt(best.distance_sq), faces_same_way};
}

Look::PartFace Look::find(std::size_t face) const {
  const auto after = std::upper_bound(parts_.begin(), parts_.end(), face,
                                      [](std::size_t f, const Part& part) { return f < part.first_face; });
  const Part& part = *(after - 1);
  return {&part, face - part.first_face};
}

const Look::Group& Look::group_of(const PartFace& own) {
  const Part& part = *own.part;
  const std::size_t group = part.mesh.face_groups.empty() ? 0 : part.mesh.face_groups[own.face];
  return part.groups[std::min(group, part.groups.size() - 1)];
}

Vec3 Look::color(const Place& place) const {
  const PartFace own = find(place.face);
  const Part& part = *own.part;
  const Group& group = group_of(own);
  const auto [a, b, c] = wedges_of(part.mesh, own.face);
  Vec3 color = group.factor;
  if (group.texture) {
    const Attribute& texcoords = group.texture->texcoords();
    const Vec2 at = blended(texcoord(texcoords, a), texcoord(texcoords, b), texcoord(texcoords, c), place.at);
    color = color.cwiseProduct(group.texture->at(at));
  }
  if (!part.mesh.colors.empty()) {
    const auto light = [&](Index wedge) { return linear_color(part.mesh.colors[wedge], part.has_srgb_colors); };
    color = color.cwiseProduct(blended(light(a), light(b), light(c), place.at));
  }
  return color.cwiseMax(0.0).cwiseMin(1.0);
}

Vec3 Look::normal(const Place& place) const {
  const PartFace own = find(place.face);
  const Part& part = *own.part;
  const auto [a, b, c] = part.normals.empty() ? wedges_of(part.mesh, own.face) : part.mesh.faces[own.face];
  const auto& normals = part.normals.empty() ? part.mesh.normals : part.normals;
  const Vec3 mean = blended(direction(normals[a]), direction(normals[b]), direction(normals[c]), place.at);
  const double length = mean.norm();
  return length > 0 ? Vec3(mean / length) : Vec3(Vec3::Zero());
}

double Look::texels() const {
  double sum = 0;
  for (const Part& part : parts_) {
    for (std::size_t f = 0; f < part.mesh.faces.size(); ++f) {
      const Group& group = group_of({&part, f});
      if (!group.texture) continue;
      const Attribute& texcoords = group.texture->texcoords();
      const auto [a, b, c] = wedges_of(part.mesh, f);
      sum += group.texture->texels({texcoord(texcoords, a), texcoord(texcoords, b), texcoord(texcoords, c)});
    }
  }
  return std::max(sum, static_cast<double>(n_faces()));
}

}  // namespace whittle::bake
