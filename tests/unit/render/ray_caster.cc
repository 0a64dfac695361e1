#include "unit/render/ray_caster.hh"

#include <algorithm>
#include <cmath>
#include <optional>

namespace whittle::render {

namespace {

using Color4 = Eigen::Vector4d;

double decode(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }
double encode(double light) { return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

struct Corner {
  Vec3 position;
  Vec3 normal;
  Eigen::Vector2d uv;
  Color4 color;
};

struct CastTriangle {
  std::array<Corner, 3> corners;
  Material material;
  const Pixels* pixels = nullptr;
};

struct Hit {
  double nearness;
  std::size_t triangle;
  Color4 color;  ///< with the shading
};

Corner corner_of(const Part& part, const Material& material, std::size_t face, std::size_t k) {
  const IndexedMesh& mesh = *part.mesh;
  const Index wedge = mesh.wedge(face, k);
  Corner corner{part.transform * mesh.positions[mesh.faces[face][k]], Vec3::Zero(), {0, 0}, {1, 1, 1, 1}};
  if (!mesh.normals.empty()) {
    const auto& n = mesh.normals[wedge];
    corner.normal = (part.transform.linear().inverse().transpose() * Vec3(n[0], n[1], n[2])).normalized();
  }
  if (!mesh.colors.empty()) {
    for (int i = 0; i < 4; ++i) corner.color[i] = mesh.colors[wedge][static_cast<std::size_t>(i)];
    if (part.vertex_colors == ColorEncoding::srgb) {
      for (int i = 0; i < 3; ++i) corner.color[i] = decode(corner.color[i]);
    }
  }
  for (const Attribute& attribute : mesh.attributes) {
    const std::optional<Texture>& texture = material.base_color_texture;
    if (!texture || attribute.name != texture->texcoord) continue;
    corner.uv = texture->transform * Eigen::Vector2d(attribute.value(wedge)[0], attribute.value(wedge)[1]);
  }
  return corner;
}

std::vector<CastTriangle> triangles_of(const Scene& scene) {
  std::vector<CastTriangle> triangles;
  for (const Part& part : scene.parts) {
    for (std::size_t f = 0; f < part.mesh->faces.size(); ++f) {
      const std::size_t group = part.mesh->face_groups.empty() ? 0 : part.mesh->face_groups[f];
      CastTriangle triangle;
      if (group < part.materials.size()) triangle.material = part.materials[group];
      if (const auto& texture = triangle.material.base_color_texture)
        triangle.pixels = &scene.images.at(texture->image);
      for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = corner_of(part, triangle.material, f, k);
      if (part.transform.linear().determinant() < 0) std::swap(triangle.corners[1], triangle.corners[2]);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

long wrapped(long i, long n, Wrap wrap) {
  if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0L, n - 1);
  const long period = wrap == Wrap::repeat ? n : 2 * n;
  const long inside = (i % period + period) % period;
  return inside < n ? inside : period - 1 - inside;
}

using Wraps = std::array<Wrap, 2>;

Color4 texel(const Pixels& pixels, const Wraps& wrap, long x, long y) {
  const auto column = static_cast<std::size_t>(wrapped(x, static_cast<long>(pixels.width), wrap[0]));
  const auto row = static_cast<std::size_t>(wrapped(y, static_cast<long>(pixels.height), wrap[1]));
  Color4 color;
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = pixels.rgba[4 * (row * pixels.width + column) + i] / 255.0;
    color[static_cast<Eigen::Index>(i)] = i < 3 ? decode(value) : value;
  }
  return color;
}

Color4 sample(const Pixels& pixels, const Wraps& wrap, const Eigen::Vector2d& uv) {
  const double x = uv[0] * static_cast<double>(pixels.width) - 0.5;
  const double y = uv[1] * static_cast<double>(pixels.height) - 0.5;
  const auto column = static_cast<long>(std::floor(x));
  const auto row = static_cast<long>(std::floor(y));
  const double s = x - std::floor(x);
  const double t = y - std::floor(y);
  const auto at = [&](long right, long down) { return texel(pixels, wrap, column + right, row + down); };
  return (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
}

Color4 shaded(const CastTriangle& triangle, const Vec3& weights, const View& view, bool is_front) {
  Color4 color = Color4::Zero();
  Vec3 normal = Vec3::Zero();
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    color += weight * triangle.corners[k].color;
    normal += weight * triangle.corners[k].normal;
    uv += weight * triangle.corners[k].uv;
  }
  const std::array<Corner, 3>& c = triangle.corners;
  if (normal.norm() < 1e-9) normal = (c[1].position - c[0].position).cross(c[2].position - c[0].position);
  normal = is_front ? normal.normalized() : -normal.normalized();
  if (triangle.pixels != nullptr) {
    color.array() *= sample(*triangle.pixels, triangle.material.base_color_texture->wrap, uv).array();
  }
  color.array() *= Color4::Map(triangle.material.base_color.data()).array();
  const double light =
      0.15 + (0.45 - 0.15) * (0.5 + 0.5 * normal.dot(view.up)) + 0.6 * std::max(normal.dot(view.to_eye), 0.0);
  color.head<3>() *= light;
  return color.cwiseMin(1).cwiseMax(0);
}

/// Where the ray against `view.to_eye` through a point meets a triangle.
std::optional<Hit> hit(const CastTriangle& triangle, std::size_t number, const View& view, const Vec3& point) {
  const Vec3 a = triangle.corners[0].position - point;
  const Vec3 b = triangle.corners[1].position - point;
  const Vec3 c = triangle.corners[2].position - point;
  Vec3 weights(view.to_eye.dot(b.cross(c)), view.to_eye.dot(c.cross(a)), view.to_eye.dot(a.cross(b)));
  const double sum = weights.sum();
  if (sum == 0) return std::nullopt;
  weights /= sum;
  if (weights.minCoeff() < 0) return std::nullopt;
  if (sum < 0 && !triangle.material.double_sided) return std::nullopt;
  const double nearness = view.to_eye.dot(weights[0] * a + weights[1] * b + weights[2] * c);
  const Material& material = triangle.material;
  Color4 color = shaded(triangle, weights, view, sum > 0);
  if (material.alpha_mode == Alpha::mask && color[3] < material.alpha_cutoff) return std::nullopt;
  if (material.alpha_mode != Alpha::blend) color[3] = 1;
  return Hit{nearness, number, color};
}

struct SampleResult {
  Color4 color;                   ///< light, and coverage
  std::vector<std::size_t> seen;  ///< triangles, from the nearest on
};

SampleResult cast_ray(const std::vector<CastTriangle>& triangles, const View& view, const Vec3& point) {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (const auto found = hit(triangles[i], i, view, point)) hits.push_back(*found);
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.nearness > b.nearness; });
  SampleResult result{Color4::Zero(), {}};
  const double grey = decode(128.0 / 255);
  double left = 1;
  for (const Hit& h : hits) {
    if (left == 0) break;
    result.color.head<3>() += left * h.color[3] * h.color.head<3>();
    result.seen.push_back(h.triangle);
    left *= 1 - h.color[3];
  }
  result.color.head<3>() += left * Vec3(grey, grey, grey);
  result.color[3] = 1 - left;
  return result;
}

/// All samples of a picture, rows from the top.
class Samples {
 public:
  Samples(const Scene& scene, const View& view, int n) : n_(n) {
    const std::vector<CastTriangle> triangles = triangles_of(scene);
    const Vec3 right = view.up.cross(view.to_eye);
    const double half = view.sphere.radius / 0.98;
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const Vec3 place = (2 * (x + 0.5) / n - 1) * right + (1 - 2 * (y + 0.5) / n) * view.up;
        samples_.push_back(cast_ray(triangles, view, view.sphere.center + half * place));
      }
    }
  }

  const SampleResult& at(int x, int y) const {
    return samples_[static_cast<std::size_t>(std::clamp(y, 0, n_ - 1) * n_ + std::clamp(x, 0, n_ - 1))];
  }

  /// The mean of a square of samples.
  Color4 mean(int x, int y, int width) const {
    Color4 sum = Color4::Zero();
    for (int v = y; v < y + width; ++v) {
      for (int u = x; u < x + width; ++u) sum += at(u, v).color;
    }
    return sum / (width * width);
  }

  /// Whether a square of samples, and those around it, see the same triangles.
  bool are_alike(int x, int y, int width) const {
    for (int v = y - 1; v <= y + width; ++v) {
      for (int u = x - 1; u <= x + width; ++u) {
        if (at(u, v).seen != at(x, y).seen) return false;
      }
    }
    return true;
  }

 private:
  int n_;
  std::vector<SampleResult> samples_;
};

}  // namespace

RayCast cast_rays(const Scene& scene, const View& view, int size, int grid) {
  const Samples samples(scene, view, size * grid);
  const auto side = static_cast<std::size_t>(size);
  RayCast cast{{side, side, {}, {}}, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Color4 mean = samples.mean(x * grid, y * grid, grid);
      Rgb pixel{};
      for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<float>(encode(mean[static_cast<Eigen::Index>(i)]));
      cast.picture.pixels.push_back(pixel);
      cast.picture.coverage.push_back(static_cast<float>(mean[3]));
      cast.is_inside.push_back(samples.are_alike(x * grid, y * grid, grid));
    }
  }
  return cast;
}

PictureDeviation deviation(const RayCast& expected, const Picture& picture) {
  PictureDeviation result{0, 0, 0};
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    double largest =
        std::abs(static_cast<double>(expected.picture.coverage[i]) - static_cast<double>(picture.coverage[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference =
          std::abs(static_cast<double>(expected.picture.pixels[i][k]) - static_cast<double>(picture.pixels[i][k]));
      result.mean += difference / (3 * static_cast<double>(picture.pixels.size()));
      largest = std::max(largest, difference);
    }
    if (!expected.is_inside[i]) continue;
    ++result.n_inside;
    result.largest_inside = std::max(result.largest_inside, largest);
  }
  return result;
}

}  // namespace whittle::render
