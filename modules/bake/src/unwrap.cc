#include "whittle/bake/unwrap.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "charts.hh"
#include "whittle/core/frame.hh"

namespace whittle::bake {

namespace {

using detail::Vec2;

/// Places charts side by side in rows, the highest first.
class RowPacker {
 public:
  RowPacker(const std::vector<FlatChart>& charts, std::size_t image_size)
      : charts_(charts),
        order_(charts.size()),
        size_(static_cast<double>(image_size)),
        gap_(std::max(2.0, size_ / 512)) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return charts[a].extent.y() > charts[b].extent.y(); });
  }

  /// The outer corner of each chart, in texels; nothing if the image has no room. \param scale texels per model unit
  std::optional<std::vector<Vec2>> places(double scale) const {
    std::vector<Vec2> places(charts_.size());
    Vec2 next(gap_, gap_);
    double row = 0;
    for (const std::size_t i : order_) {
      const Vec2 extent = (charts_[i].extent * scale).array().ceil();
      if (next.x() + extent.x() + gap_ > size_) {
        next = Vec2(gap_, next.y() + row);
        row = 0;
      }
      if ((next + extent).maxCoeff() + gap_ > size_) return std::nullopt;
      places[i] = next;
      next.x() += extent.x() + gap_;
      row = std::max(row, extent.y() + gap_);
    }
    return places;
  }

  /// The largest scale at which there is room, to a millionth of `most`. 0 if there is none.
  double largest_scale(double most) const {
    double low = 0;
    double high = most;
    for (int step = 0; step < 20; ++step) {
      const double middle = 0.5 * (low + high);
      (places(middle) ? low : high) = middle;
    }
    return low;
  }

 private:
  const std::vector<FlatChart>& charts_;
  std::vector<std::size_t> order_;
  double size_, gap_;
};

double area_of(const std::vector<FlatChart>& charts) {
  double twice = 0;
  for (const FlatChart& chart : charts) {
    for (const auto& t : chart.triangles) twice += std::abs(detail::area_on_image(t[0], t[1], t[2]));
  }
  return twice / 2;
}

}  // namespace

Unwrapping unwrap(const IndexedMesh& mesh, std::size_t image_size) {
  const Frame frame = Frame::of_points(mesh.positions);
  std::vector<Vec3> positions = mesh.positions;
  for (Vec3& p : positions) p = frame.to_frame(p);
  std::vector<FlatChart> charts;
  for (Chart& chart : make_charts(positions, mesh.faces)) {
    std::vector<FlatChart> flat = lay_flat(positions, mesh.faces, std::move(chart));
    std::move(flat.begin(), flat.end(), std::back_inserter(charts));
  }
  const double area = area_of(charts);
  if (!(area > 0)) throw std::invalid_argument("the mesh has no area");
  const RowPacker packer(charts, image_size);
  const auto size = static_cast<double>(image_size);
  const double scale = packer.largest_scale(size / std::sqrt(area));
  const auto places = packer.places(scale);
  if (!(scale > 0) || !places) {
    throw std::invalid_argument("an image of " + std::to_string(image_size) + " has no room for " +
                                std::to_string(charts.size()) + " charts");
  }
  Unwrapping result{std::vector<Index>(mesh.faces.size()), {}, std::vector<Vec2>(3 * mesh.faces.size()), 0};
  for (std::size_t c = 0; c < charts.size(); ++c) {
    result.right.push_back(charts[c].right);
    for (std::size_t i = 0; i < charts[c].faces.size(); ++i) {
      const std::size_t f = charts[c].faces[i];
      result.charts[f] = static_cast<Index>(c);
      for (std::size_t k = 0; k < 3; ++k) {
        result.texcoords[3 * f + k] = ((*places)[c] + scale * charts[c].triangles[i][k]) / size;
      }
    }
  }
  result.fill = area * scale * scale / (size * size);
  return result;
}

}  // namespace whittle::bake
