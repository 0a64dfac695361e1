#include "packed_look.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "packed_values.hh"
#include "whittle/core/wedges.hh"

namespace whittle::report {
namespace {

constexpr double per_texture = 65536;

std::vector<Index> vertices_of_further_wedges(const IndexedMesh& mesh) {
  std::vector<Index> vertices(n_wedges(mesh) - mesh.positions.size());
  for (std::size_t corner = 0; corner < mesh.wedges.size(); ++corner) {
    const std::size_t wedge = mesh.wedges[corner];
    if (wedge >= mesh.positions.size()) vertices[wedge - mesh.positions.size()] = mesh.faces[corner / 3][corner % 3];
  }
  return vertices;
}

Json pack_texcoords(const Attribute& attribute, PageBytes& bytes) {
  std::vector<std::array<std::int32_t, 2>> packed(attribute.size());
  for (std::size_t w = 0; w < packed.size(); ++w) {
    for (std::size_t d = 0; d < 2; ++d) {
      constexpr double most = 32767;
      packed[w][d] =
          static_cast<std::int32_t>(std::lround(std::clamp(attribute.value(w)[d], -most, most) * per_texture));
    }
  }
  return {{"name", attribute.name}, {"values", bytes.add(packed)}};
}

std::int16_t packed_share(double share) {
  constexpr double most = 32767;
  return static_cast<std::int16_t>(std::lround(std::clamp(share, -1.0, 1.0) * most));
}

/// Cigolle and others, "A survey of efficient representations for independent unit vectors", 2014.
std::array<std::int16_t, 2> packed_direction(const std::array<float, 3>& direction) {
  const Vec3 d(direction[0], direction[1], direction[2]);
  const double sum = d.lpNorm<1>();
  if (!(sum > 0)) return {0, 0};
  const double x = d.x() / sum;
  const double y = d.y() / sum;
  if (d.z() >= 0) return {packed_share(x), packed_share(y)};
  return {packed_share(std::copysign(1 - std::abs(y), x)), packed_share(std::copysign(1 - std::abs(x), y))};
}

Json pack_normals(const IndexedMesh& mesh, PageBytes& bytes) {
  if (mesh.normals.empty()) return nullptr;
  std::vector<std::array<std::int16_t, 2>> packed;
  for (const auto& normal : mesh.normals) packed.push_back(packed_direction(normal));
  return bytes.add(packed);
}

double encoded_as_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Json pack_colors(const PageSurface& surface, PageBytes& bytes) {
  if (surface.mesh.colors.empty()) return nullptr;
  std::vector<std::array<std::uint8_t, 4>> packed;
  for (const Color& color : surface.mesh.colors) {
    auto& of_one = packed.emplace_back();
    for (std::size_t d = 0; d < 4; ++d) {
      const double share = std::clamp(double{color[d]}, 0.0, 1.0);
      const bool is_encoded = d == 3 || surface.colors == ColorEncoding::srgb;
      of_one[d] = static_cast<std::uint8_t>(std::lround(255 * (is_encoded ? share : encoded_as_srgb(share))));
    }
  }
  return bytes.add(packed);
}

/// The sets of texture coordinates that materials use.
class TexcoordSets {
 public:
  explicit TexcoordSets(const IndexedMesh& mesh) : mesh_(mesh) {}

  /// \return its number in the page, or null if the mesh doesn't have it
  Json number_of(const std::string& name) {
    const auto found = std::find_if(mesh_.attributes.begin(), mesh_.attributes.end(), [&](const Attribute& attribute) {
      return attribute.name == name && attribute.n_components >= 2;
    });
    if (found == mesh_.attributes.end()) return nullptr;
    const auto known = std::find(sets_.begin(), sets_.end(), &*found);
    const auto number = static_cast<std::size_t>(known - sets_.begin());
    if (known == sets_.end()) sets_.push_back(&*found);
    return number;
  }
  Json pack(PageBytes& bytes) const {
    Json sets = Json::array();
    for (const Attribute* set : sets_) sets.push_back(pack_texcoords(*set, bytes));
    return sets;
  }

 private:
  const IndexedMesh& mesh_;
  std::vector<const Attribute*> sets_;
};

Json pack_material(Material material, TexcoordSets& texcoords, PageImages& images) {
  constexpr std::array wraps{"repeat", "mirror", "clamp"};
  constexpr std::array alphas{"opaque", "mask", "blend"};
  const Texture texture = material.base_color_texture.value_or(Texture{});
  const bool is_image = texture.image && !media_type(texture.image->bytes).empty();
  const Json set = is_image ? texcoords.number_of(texture.texcoord) : Json(nullptr);
  if (set.is_null()) material.base_color_texture.reset();
  const auto& transform = texture.transform.matrix();
  const auto wrap = [&](std::size_t d) { return wraps[static_cast<std::size_t>(texture.wrap[d])]; };
  return {{"name", material.name},
          {"colour", base_color_factor(material)},
          {"image", set.is_null() ? Json(nullptr) : Json(images.number_of(*texture.image))},
          {"texcoords", set},
          {"transform",
           {transform(0, 0), transform(0, 1), transform(0, 2), transform(1, 0), transform(1, 1), transform(1, 2)}},
          {"wrap", {wrap(0), wrap(1)}},
          {"alpha", alphas[static_cast<std::size_t>(material.alpha_mode)]},
          {"cutoff", material.alpha_cutoff}};
}

/// Null if there are no materials. \tparam Faces has `faces` and `face_groups`
template <class Faces>
Json pack_groups(const Faces& of, std::size_t n_materials, PageBytes& bytes) {
  if (n_materials == 0) return nullptr;
  constexpr std::size_t most = 65535;
  const auto last = static_cast<std::uint16_t>(std::min(n_materials, most));
  std::vector<std::array<std::uint16_t, 2>> packed((of.faces.size() + 1) / 2);
  for (std::size_t f = 0; f < of.faces.size(); ++f) {
    const std::size_t group = of.face_groups.empty() ? 0 : of.face_groups[f];
    packed[f / 2][f % 2] = group < last ? static_cast<std::uint16_t>(group) : last;
  }
  return bytes.add(packed);
}

const char* name_of(AttributeKind kind) {
  return kind == AttributeKind::texcoord ? "texcoord" : kind == AttributeKind::color ? "colour" : "normal";
}

Json pack(const AttributeMap& map, PageBytes& bytes) {
  ByteGroups values;
  for (const double deviation : map.deviations) values.add(packed_value(deviation, {map.max, map.usual}));
  return {{"name", map.name},
          {"kind", name_of(map.kind)},
          {"max", map.max},
          {"usual", map.usual},
          {"values", bytes.add(values.groups())}};
}

}  // namespace

std::size_t PageImages::number_of(const Image& image) {
  const auto [found, is_new] = numbers_.try_emplace(image.bytes, files_.size());
  if (is_new) files_.push_back(found->first);
  return found->second;
}

Json PageImages::pack(PageBytes& bytes) const {
  Json packed = Json::array();
  for (const std::string_view file : files_) {
    packed.push_back({{"type", media_type(file)}, {"bytes", bytes.add_file(file)}});
  }
  return packed;
}

Json pack_look(const PageSurface& surface, PageBytes& bytes, PageImages& images) {
  const IndexedMesh& mesh = surface.mesh;
  if (surface.materials.empty() && mesh.normals.empty() && mesh.colors.empty() && surface.attribute_maps.empty()) {
    return nullptr;
  }
  TexcoordSets texcoords(mesh);
  Json materials = Json::array();
  for (const Material& material : surface.materials) {
    materials.push_back(pack_material(material, texcoords, images));
  }
  if (!materials.empty()) materials.push_back(pack_material({}, texcoords, images));
  Json maps = Json::array();
  for (const AttributeMap& map : surface.attribute_maps) maps.push_back(pack(map, bytes));
  return {{"wedges", bytes.add(vertices_of_further_wedges(mesh))},
          {"count", n_wedges(mesh)},
          {"texcoords", texcoords.pack(bytes)},
          {"normals", pack_normals(mesh, bytes)},
          {"colours", pack_colors(surface, bytes)},
          {"linear", surface.colors == ColorEncoding::linear},
          {"groups", pack_groups(mesh, surface.materials.size(), bytes)},
          {"coarse_groups", pack_groups(surface.coarse, surface.materials.size(), bytes)},
          {"materials", std::move(materials)},
          {"maps", std::move(maps)}};
}

}  // namespace whittle::report
