#include "attributes/texture_atlas.hh"

#include <algorithm>
#include <cmath>
#include <utility>

namespace whittle::detail {
namespace {

Eigen::AlignedBox2d box_of(const ImageTriangle& triangle) {
  Eigen::AlignedBox2d box(triangle[0]);
  box.extend(triangle[1]);
  box.extend(triangle[2]);
  return box;
}

/// \pre the corners are counter-clockwise
bool is_in(const Vec2& point, const ImageTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  return area_on_image(a, b, point) >= 0 && area_on_image(b, c, point) >= 0 && area_on_image(c, a, point) >= 0;
}

}  // namespace

TextureAtlas::TextureAtlas(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components,
                           std::vector<Index> charts)
    : chart_of_wedge_(std::move(charts)), group_of_chart_(chart_of_wedge_.size(), invalid_index) {
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    Index& group = group_of_chart_[chart_of_wedge_[original.wedge(f, 0)]];
    if (group != invalid_index) continue;
    ++n_charts_;
    group = original.face_groups.empty() ? 0 : original.face_groups[f];
  }
  if (!has_several_charts()) return;
  add_faces(original, texcoords, n_components);
  make_grid();
}

void TextureAtlas::add_faces(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components) {
  faces_.reserve(original.faces.size());
  area_of_chart_.resize(chart_of_wedge_.size());
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    Face face{{}, chart_of_wedge_[original.wedge(f, 0)]};
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = Vec2(&texcoords[original.wedge(f, k) * n_components]);
    const double area = area_on_image(face.corners[0], face.corners[1], face.corners[2]);
    area_of_chart_[face.chart] += std::abs(area);
    if (area < 0) std::swap(face.corners[1], face.corners[2]);
    if (area != 0) faces_.push_back(face);
  }
}

std::size_t TextureAtlas::cell_along(int axis, double number) const {
  const double low = box_.min()[axis];
  const double high = box_.max()[axis];
  const auto n = static_cast<double>(n_cells_[static_cast<std::size_t>(axis)]);
  const double cell = high > low ? (number - low) / (high - low) * n : 0;
  return static_cast<std::size_t>(std::clamp(cell, 0.0, n - 1));
}

template <class Use>
void TextureAtlas::for_each_cell(const Box& box, const Use& use) const {
  const std::size_t last_x = cell_along(0, box.max().x());
  const std::size_t last_y = cell_along(1, box.max().y());
  for (std::size_t y = cell_along(1, box.min().y()); y <= last_y; ++y) {
    for (std::size_t x = cell_along(0, box.min().x()); x <= last_x; ++x) use(static_cast<Index>(y * n_cells_[0] + x));
  }
}

/// About as many cells as faces; fewer where faces are so long that they would be in many.
void TextureAtlas::make_grid() {
  constexpr std::size_t most_cells_a_face = 8;
  for (const Face& face : faces_) box_.extend(box_of(face.corners));
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces_.size()))) + 1;
  for (n_cells_ = {side, side};; n_cells_ = {(n_cells_[0] + 1) / 2, (n_cells_[1] + 1) / 2}) {
    std::size_t n_entries = 0;
    for (const Face& face : faces_) for_each_cell(box_of(face.corners), [&](Index) { ++n_entries; });
    if (n_entries <= most_cells_a_face * faces_.size() || n_cells_[0] == 1) break;
  }
  cells_ = IndexLists<Entry, std::size_t>(n_cells_[0] * n_cells_[1], [&](const auto& emit) {
    for (Index f = 0; f < faces_.size(); ++f) {
      const Eigen::AlignedBox2d box = box_of(faces_[f].corners);
      const Eigen::Array2f low = box.min().cast<float>();
      const Eigen::Array2f high = box.max().cast<float>();
      const Entry entry{low.x(), high.x(), low.y(), high.y(), f, faces_[f].chart};
      for_each_cell(box, [&](Index cell) { emit(cell, entry); });
    }
  });
}

bool TextureAtlas::is_on_another(const Vec2& point, Index own) const {
  bool is_on_another = false;
  const std::size_t cell = cell_along(1, point.y()) * n_cells_[0] + cell_along(0, point.x());
  const auto x = static_cast<float>(point.x());  // rounding keeps the order
  const auto y = static_cast<float>(point.y());
  for (const auto& [low_x, high_x, low_y, high_y, face, chart] : cells_.of(static_cast<Index>(cell))) {
    const bool is_own = chart == own;
    if (!is_own && (is_on_another || group_of_chart_[chart] != group_of_chart_[own])) continue;
    const float beyond = std::max(std::max(low_x - x, x - high_x), std::max(low_y - y, y - high_y));
    if (beyond > 0) continue;
    if (!is_in(point, faces_[face].corners)) continue;
    if (is_own) return false;
    is_on_another = true;
  }
  return is_on_another;
}

}  // namespace whittle::detail
