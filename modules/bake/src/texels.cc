#include "texels.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "whittle/core/detail/item_groups.hh"
#include "whittle/core/geometry/image_triangle.hh"

namespace whittle::bake {

namespace {

using detail::ImageTriangle;
using detail::Vec2;

constexpr std::size_t band_rows = 16;
constexpr double far_away = std::numeric_limits<double>::infinity();

/// Some rows of the image. One thread works on a band, on its faces in their order.
struct Band {
  std::size_t first_row;
  std::span<Texel> texels;
  std::size_t n_samples = 0;
  std::size_t n_missed = 0;
};

/// The corners of a face, on the image and in space.
struct FaceCorners {
  ImageTriangle image;  ///< in samples
  Corners positions, normals, tangents;
  double step;  ///< largest distance between neighbouring samples, model units, roughly
};

/// A place on a face, as a sum over its corners.
struct Weights {
  std::array<double, 3> of_corners;

  Weights(const ImageTriangle& triangle, const Vec2& p) {
    const auto& [a, b, c] = triangle;
    const double area = detail::area_on_image(a, b, c);
    of_corners = {detail::area_on_image(p, b, c) / area, detail::area_on_image(a, p, c) / area,
                  detail::area_on_image(a, b, p) / area};
  }
  bool are_inside() const { return *std::min_element(of_corners.begin(), of_corners.end()) >= 0; }
  Vec3 sum(const Corners& values) const {
    return of_corners[0] * values[0] + of_corners[1] * values[1] + of_corners[2] * values[2];
  }
};

/// A normal in the frame of the tangents, as in glTF 2.0, section 3.7.2: the bitangent is the product of normal and
/// tangent, each corner's.
Vec3 in_tangent_space(const FaceCorners& corners, const Weights& weights, const Vec3& wanted) {
  constexpr double least = 0.05;  // below it, the place would be lit from behind
  Corners bitangents;
  for (std::size_t k = 0; k < 3; ++k) bitangents[k] = corners.normals[k].cross(corners.tangents[k]);
  Eigen::Matrix3d frame;
  frame << weights.sum(corners.tangents).normalized(), weights.sum(bitangents).normalized(),
      weights.sum(corners.normals).normalized();
  if (!(std::abs(frame.determinant()) > 1e-3)) return Vec3::UnitZ();
  const Vec3 local = (frame.inverse() * wanted).normalized();
  return local.z() > least ? local : Vec3(Vec3::UnitZ());
}

class Sampler {
 public:
  Sampler(const Look& look, const IndexedMesh& mesh, const ImageGrid& grid)
      : look_(look), mesh_(mesh), grid_(grid), has_tangents_(mesh.attributes.size() > 1) {}

  void add(Index face, Band& band) const {
    const FaceCorners corners = corners_of_face(face);
    const auto& [a, b, c] = corners.image;
    if (detail::area_on_image(a, b, c) == 0) return;
    const Vec2 low = a.cwiseMin(b).cwiseMin(c);
    const Vec2 high = a.cwiseMax(b).cwiseMax(c);
    const std::size_t begin = band.first_row * grid_.texel_samples;
    const std::size_t end = begin + band_rows * grid_.texel_samples;
    double near = far_away;
    for (std::size_t row = std::max(begin, number(low.y())); row < std::min(end, number(high.y()) + 1); ++row) {
      for (std::size_t column = number(low.x()); column <= number(high.x()); ++column) {
        const Vec2 p(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
        const Weights weights(corners.image, p);
        if (weights.are_inside()) near = add(corners, weights, near, texel_at(p, band), band);
      }
    }
    const Vec2 middle = (a + b + c) / 3;
    if (number(middle.y()) >= begin && number(middle.y()) < end) {
      add(corners, Weights(corners.image, middle), near, texel_at(middle, band), band);
    }
  }

  /// The first and the last row of texels that a face may touch.
  std::array<std::size_t, 2> rows_of(Index face) const {
    std::array<double, 3> y{};
    for (std::size_t k = 0; k < 3; ++k) y[k] = mesh_.attributes[0].value(mesh_.wedge(face, k))[1];
    const auto [low, high] = std::minmax_element(y.begin(), y.end());
    const auto size = static_cast<double>(grid_.size);
    const auto row = [&](double at) { return static_cast<std::size_t>(std::clamp(at * size, 0.0, size - 1)); };
    return {row(*low), row(*high)};
  }

 private:
  std::size_t n_along() const { return grid_.size * grid_.texel_samples; }
  std::size_t number(double at) const {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(n_along() - 1)));
  }
  Texel& texel_at(const Vec2& p, const Band& band) const {
    const std::size_t row = number(p.y()) / grid_.texel_samples - band.first_row;
    return band.texels[row * grid_.size + number(p.x()) / grid_.texel_samples];
  }

  FaceCorners corners_of_face(Index face) const {
    FaceCorners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index wedge = mesh_.wedge(face, k);
      const auto texcoord = mesh_.attributes[0].value(wedge);
      corners.image[k] = static_cast<double>(n_along()) * Vec2(texcoord[0], texcoord[1]);
      corners.positions[k] = mesh_.positions[mesh_.faces[face][k]];
      const auto& normal = mesh_.normals[wedge];
      corners.normals[k] = Vec3(normal[0], normal[1], normal[2]);
      if (!has_tangents_) continue;
      const auto tangent = mesh_.attributes[1].value(wedge);
      corners.tangents[k] = Vec3(tangent[0], tangent[1], tangent[2]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double samples = (corners.image[(k + 1) % 3] - corners.image[k]).norm();
      const double length = (corners.positions[(k + 1) % 3] - corners.positions[k]).norm();
      if (samples > 0) corners.step = std::max(corners.step, 2 * length / samples);
    }
    return corners;
  }

  /// \return a distance in which the next sample probably has a place
  double add(const FaceCorners& corners, const Weights& weights, double near, Texel& texel, Band& band) const {
    const Place place = look_.nearest(weights.sum(corners.positions), weights.sum(corners.normals), near);
    ++band.n_samples;
    ++texel.n_samples;
    texel.light += look_.color(place).cast<float>();
    if (has_tangents_) texel.normal += in_tangent_space(corners, weights, look_.normal(place)).cast<float>();
    if (place.faces_same_way) return place.distance + corners.step;
    ++band.n_missed;
    return far_away;
  }

  const Look& look_;
  const IndexedMesh& mesh_;
  ImageGrid grid_;
  bool has_tangents_;
};

}  // namespace

Texels look_up_texels(const Look& look, const IndexedMesh& mesh, const ImageGrid& grid,
                      const detail::Workers& workers) {
  const Sampler sampler(look, mesh, grid);
  const std::size_t n_bands = grid.size / band_rows;
  const detail::ItemGroups faces(mesh.faces.size(), n_bands, workers.threads, [&](Index face, const auto& use) {
    const auto [first, last] = sampler.rows_of(face);
    for (std::size_t band = first / band_rows; band <= last / band_rows; ++band) use(band);
  });
  Texels result{std::vector<Texel>(grid.size * grid.size)};
  std::vector<Band> bands(n_bands);
  for_each_block(n_bands, workers, [&](std::size_t i) {
    const std::size_t length = band_rows * grid.size;
    bands[i] = {i * band_rows, std::span(result.texels).subspan(i * length, length)};
    for (const Index face : faces.of(i)) sampler.add(face, bands[i]);
  });
  for (const Band& band : bands) {
    result.n_samples += band.n_samples;
    result.n_missed += band.n_missed;
  }
  return result;
}

}  // namespace whittle::bake
