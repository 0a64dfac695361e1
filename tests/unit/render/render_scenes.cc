#include "unit/render/render_scenes.hh"

#include <cmath>
#include <utility>

#include "unit/render/image_files.hh"

namespace whittle::render {

Attribute texcoords(const std::vector<Uv>& values) {
  Attribute attribute;
  attribute.name = "TEXCOORD_0";
  attribute.kind = AttributeKind::texcoord;
  attribute.n_components = 2;
  for (const Uv& uv : values) attribute.values.insert(attribute.values.end(), uv.begin(), uv.end());
  return attribute;
}

IndexedMesh square(double z) {
  IndexedMesh mesh;
  mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  mesh.attributes = {texcoords({{0, 1}, {1, 1}, {1, 0}, {0, 0}})};
  return mesh;
}

IndexedMesh box_with_seams() {
  IndexedMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  const std::array<Index, 4> sides[] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                        {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
  std::vector<Uv> uvs;
  for (const std::array<Index, 4>& side : sides) {
    const auto first = static_cast<Index>(uvs.size());
    mesh.faces.push_back({side[0], side[1], side[2]});
    mesh.faces.push_back({side[0], side[2], side[3]});
    mesh.wedges.insert(mesh.wedges.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    uvs.insert(uvs.end(), {{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  }
  mesh.attributes = {texcoords(uvs)};
  return mesh;
}

IndexedMesh smooth_octahedron() {
  IndexedMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (const Vec3& p : mesh.positions) {
    mesh.normals.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  return mesh;
}

std::shared_ptr<const Image> make_image(std::size_t width, const std::vector<std::uint32_t>& pixels) {
  std::vector<std::uint8_t> rgba;
  for (const std::uint32_t pixel : pixels) {
    for (const int shift : {24, 16, 8, 0}) rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
  }
  const PngSettings settings{.kind = PngKind::rgba,
                             .width = static_cast<unsigned>(width),
                             .height = static_cast<unsigned>(pixels.size() / width)};
  return std::make_shared<const Image>(Image{.bytes = png_file(settings, std::move(rgba))});
}

std::shared_ptr<const Image> colorful_image() {
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < 64; ++i) pixels.push_back((i * 0x9E3779B1U) | 0xFFU);
  return make_image(8, pixels);
}

Scene scene_of(const IndexedMesh& mesh, const Material& material, const Eigen::Affine3d& transform) {
  Part part;
  part.mesh = &mesh;
  part.materials = {material};
  part.transform = transform;
  Scene scene{{part}};
  EXPECT_TRUE(decode_images(scene).empty());
  return scene;
}

Material textured(std::shared_ptr<const Image> image, const std::array<Wrap, 2>& wrap) {
  return {.base_color_texture = Texture{.image = std::move(image), .wrap = wrap}};
}

View from_front() { return view_from({Vec3::Zero(), 1}, Vec3::UnitZ()); }

std::array<int, 3> pixel_at(const Picture& picture, std::size_t x, std::size_t y) {
  std::array<int, 3> color{};
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = static_cast<int>(std::lround(255 * picture.pixels[y * picture.width + x][i]));
  }
  return color;
}

}  // namespace whittle::render
