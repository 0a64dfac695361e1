#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bytes.hh"
#include "whittle/core/bytes/glb.hh"
#include "whittle/core/frame.hh"
#include "whittle/progressive/geomorph.hh"
#include "whittle/version.hh"

// glTF 2.0: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html.

namespace whittle::progressive {
namespace {

using Json = nlohmann::ordered_json;

// Names of section 5 for its numbers.
constexpr int float_component = 5126;
constexpr int uint32_component = 5125;
constexpr int vertex_buffer = 34962;
constexpr int index_buffer = 34963;

/// The type of a vector with `n` components.
const char* type_of(std::size_t n) {
  constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return types[n - 1];
}

/// The one buffer of a file, and the views and accessors of its parts. Each part is a multiple of four bytes.
class GlbBuffer {
 public:
  /// \param n_components of each item \param target `vertex_buffer`, `index_buffer`, or 0 for other data
  /// \return the number of the accessor
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, std::size_t n_components, int target, bool with_range = false) {
    const std::size_t begin = bytes().size();
    for (const Number number : numbers) bytes_.number(number);
    Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes().size() - begin}};
    if (target != 0) view["target"] = target;
    views_.push_back(std::move(view));
    Json accessor = {{"bufferView", views_.size() - 1},
                     {"componentType", std::is_same_v<Number, float> ? float_component : uint32_component},
                     {"count", numbers.size() / n_components},
                     {"type", type_of(n_components)}};
    if (with_range) add_range(numbers, n_components, accessor);
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }

  const std::string& bytes() { return bytes_.bytes(); }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }

 private:
  template <class Number>
  static void add_range(const std::vector<Number>& numbers, std::size_t n_components, Json& accessor) {
    std::vector<Number> low(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(n_components));
    std::vector<Number> high = low;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      low[i % n_components] = std::min(low[i % n_components], numbers[i]);
      high[i % n_components] = std::max(high[i % n_components], numbers[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }

  ByteWriter bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

std::vector<float> rounded_positions(const IndexedMesh& mesh, const Vec3& center) {
  std::vector<float> numbers;
  numbers.reserve(3 * mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    for (int i = 0; i < 3; ++i) {
      const double x = p[i] - center[i];
      if (!(std::abs(x) <= std::numeric_limits<float>::max())) {
        throw std::range_error("geomorph: a coordinate is too large for glTF, whose numbers have 32 bits");
      }
      numbers.push_back(static_cast<float>(x));
    }
  }
  return numbers;
}

/// glTF has no zero normals.
std::vector<float> unit_normals(const IndexedMesh& mesh) {
  std::vector<float> numbers;
  numbers.reserve(3 * mesh.normals.size());
  for (const auto& n : mesh.normals) {
    const bool is_zero = n[0] == 0 && n[1] == 0 && n[2] == 0;
    numbers.insert(numbers.end(), {n[0], n[1], is_zero ? 1 : n[2]});
  }
  return numbers;
}

std::vector<float> color_numbers(const IndexedMesh& mesh) {
  std::vector<float> numbers;
  numbers.reserve(4 * mesh.colors.size());
  for (const Color& color : mesh.colors) numbers.insert(numbers.end(), color.begin(), color.end());
  return numbers;
}

std::vector<float> difference(const std::vector<float>& to, const std::vector<float>& from) {
  std::vector<float> numbers(from.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = to[i] - from[i];
  return numbers;
}

/// The mesh with its morph target.
Json add_mesh(const Geomorph& geomorph, const Vec3& center, GlbBuffer& buffer) {
  Json base;
  Json target;
  const auto add = [&](const char* name, std::size_t n_components, const std::vector<float>& from,
                       const std::vector<float>& to) {
    const bool has_range = std::strcmp(name, "POSITION") == 0;
    base[name] = buffer.add(from, n_components, vertex_buffer, has_range);
    target[name] = buffer.add(difference(to, from), n_components, vertex_buffer, has_range);
  };
  const IndexedMesh& fine = geomorph.fine();
  const IndexedMesh& coarse = geomorph.coarse();
  add("POSITION", 3, rounded_positions(fine, center), rounded_positions(coarse, center));
  add("NORMAL", 3, unit_normals(fine), unit_normals(coarse));
  if (!fine.colors.empty()) add("COLOR_0", 4, color_numbers(fine), color_numbers(coarse));
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * fine.faces.size());
  for (const Triangle& face : fine.faces) corners.insert(corners.end(), face.begin(), face.end());
  const std::size_t indices = buffer.add(corners, 1, index_buffer);

  Json primitive = {{"attributes", base}, {"indices", indices}, {"targets", Json::array({target})}};
  return {{"primitives", Json::array({primitive})},
          {"weights", Json::array({0})},
          {"extras", {{"targetNames", Json::array({std::to_string(geomorph.n_coarse_faces()) + " faces"})}}}};
}

/// There and back.
Json add_animation(GlbBuffer& buffer) {
  const std::size_t times = buffer.add(std::vector<float>{0, 2, 4}, 1, 0, true);
  const std::size_t weights = buffer.add(std::vector<float>{0, 1, 0}, 1, 0);
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  const Json sampler = {{"input", times}, {"output", weights}, {"interpolation", "LINEAR"}};
  return {{"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}};
}

}  // namespace

void write_glb(std::ostream& out, const Geomorph& geomorph) {
  if (geomorph.fine().faces.empty()) throw std::invalid_argument("geomorph: glTF has no mesh without faces");
  const Vec3 center = Frame::of_points(geomorph.fine().positions).center;
  GlbBuffer buffer;
  Json node = {{"mesh", 0}};
  if (!center.isZero()) node["translation"] = {center.x(), center.y(), center.z()};
  Json json = {{"asset", {{"version", "2.0"}, {"generator", std::string("whittle ") + WHITTLE_VERSION_STRING}}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
               {"nodes", Json::array({node})}};
  json["meshes"] = Json::array({add_mesh(geomorph, center, buffer)});
  json["animations"] = Json::array({add_animation(buffer)});
  json["accessors"] = buffer.accessors();
  json["bufferViews"] = buffer.views();
  json["buffers"] = Json::array({{{"byteLength", buffer.bytes().size()}}});
  const std::string file = join_glb(json.dump(-1, ' ', false, Json::error_handler_t::replace), buffer.bytes());
  out.write(file.data(), static_cast<std::streamsize>(file.size()));
}

}  // namespace whittle::progressive
