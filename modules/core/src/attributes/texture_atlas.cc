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
    : chart_of_wedge_(std::move(charts)) {
  number_charts(original);
  if (!has_several_charts()) return;
  add_faces(original, texcoords, n_components);
  make_grid();
}

void TextureAtlas::number_charts(const IndexedMesh& original) {
  std::vector<std::pair<Index, Index>> groups_and_charts;  // a chart's group is that of its first face
  std::vector<bool> is_found(chart_of_wedge_.size());
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    const Index chart = chart_of_wedge_[original.wedge(f, 0)];
    if (is_found[chart]) continue;
    is_found[chart] = true;
    groups_and_charts.emplace_back(original.face_groups.empty() ? 0 : original.face_groups[f], chart);
  }
  std::sort(groups_and_charts.begin(), groups_and_charts.end());
  std::vector<Index> numbers(chart_of_wedge_.size(), invalid_index);
  for (auto group = groups_and_charts.begin(); group != groups_and_charts.end();) {
    const auto end =
        std::find_if(group, groups_and_charts.end(), [&](const auto& c) { return c.first != group->first; });
    const Numbers same{groups_.size(), groups_.size() + static_cast<std::size_t>(end - group)};
    for (; group != end; ++group) {
      numbers[group->second] = static_cast<Index>(groups_.size());
      groups_.push_back(same);
    }
  }
  for (Index& chart : chart_of_wedge_) chart = numbers[chart];
}

void TextureAtlas::add_faces(const IndexedMesh& original, std::span<const double> texcoords, std::size_t n_components) {
  faces_.reserve(original.faces.size());
  area_of_chart_.resize(groups_.size());
  for (std::size_t f = 0; f < original.faces.size(); ++f) {
    Face face{{}, chart_of_wedge_[original.wedge(f, 0)]};
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = Vec2(&texcoords[original.wedge(f, k) * n_components]);
    const double area = area_on_image(face.corners[0], face.corners[1], face.corners[2]);
    area_of_chart_[face.chart] += std::abs(area);
    if (area < 0) std::swap(face.corners[1], face.corners[2]);
    if (area != 0) faces_.push_back(face);
  }
  std::stable_sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.chart < b.chart; });
}

void TextureAtlas::divide(std::size_t n_cells) {
  n_cells_ = n_cells;
  for (const int axis : {0, 1}) {
    const double cells_a_unit = static_cast<double>(n_cells) / (box_.max()[axis] - box_.min()[axis]);
    cells_a_unit_[axis] = std::isfinite(cells_a_unit) ? cells_a_unit : 0;
  }
}

std::size_t TextureAtlas::cell_along(int axis, double number) const {
  const double cell = (number - box_.min()[axis]) * cells_a_unit_[axis];
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(n_cells_ - 1)));
}

template <class Use>
void TextureAtlas::for_each_cell(const Box& box, const Use& use) const {
  const std::size_t last_x = cell_along(0, box.max().x());
  const std::size_t last_y = cell_along(1, box.max().y());
  for (std::size_t y = cell_along(1, box.min().y()); y <= last_y; ++y) {
    for (std::size_t x = cell_along(0, box.min().x()); x <= last_x; ++x) use(static_cast<Index>(y * n_cells_ + x));
  }
}

/// About as many cells as faces; fewer where faces are so long that they would be in many.
void TextureAtlas::make_grid() {
  constexpr std::size_t most_cells_a_face = 8;
  for (const Face& face : faces_) box_.extend(box_of(face.corners));
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces_.size()))) + 1;
  for (std::size_t n = side;; n = (n + 1) / 2) {
    divide(n);
    std::size_t n_entries = 0;
    for (const Face& face : faces_) for_each_cell(box_of(face.corners), [&](Index) { ++n_entries; });
    if (n_entries <= most_cells_a_face * faces_.size() || n == 1) break;
  }
  cells_ = IndexLists<Entry, std::size_t>(n_cells_ * n_cells_, [&](const auto& emit) {
    for (Index f = 0; f < faces_.size(); ++f) {
      const Eigen::AlignedBox2d box = box_of(faces_[f].corners);
      const Eigen::Array2f low = box.min().cast<float>();
      const Eigen::Array2f high = box.max().cast<float>();
      const Entry entry{low.x(), high.x(), low.y(), high.y(), f, faces_[f].chart};
      for_each_cell(box, [&](Index cell) { emit(cell, entry); });
    }
  });
}

Index TextureAtlas::face_at(const Vec2& point, std::span<const Entry> entries) const {
  const auto x = static_cast<float>(point.x());  // rounding keeps the order
  const auto y = static_cast<float>(point.y());
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) {
    const float beyond = std::max(std::max(e.low_x - x, x - e.high_x), std::max(e.low_y - y, y - e.high_y));
    return !(beyond > 0) && is_in(point, faces_[e.face].corners);
  });
  return found == entries.end() ? invalid_index : found->face;
}

bool TextureAtlas::is_on_another(const Vec2& point, Index own, Near& near) const {
  const auto is_at = [&](Index face) { return face != invalid_index && is_in(point, faces_[face].corners); };
  if (is_at(near.own)) return false;
  const std::size_t cell = cell_along(1, point.y()) * n_cells_ + cell_along(0, point.x());
  const std::span<const Entry> entries = cells_.of(static_cast<Index>(cell));
  const auto from = [&](std::size_t chart) {
    return std::partition_point(entries.begin(), entries.end(), [&](const Entry& e) { return e.chart < chart; });
  };
  const auto own_begin = from(own);
  const auto own_end = from(own + 1);
  near.own = face_at(point, {own_begin, own_end});
  if (near.own != invalid_index) return false;
  if (is_at(near.other)) return true;
  near.other = face_at(point, {from(groups_[own].begin), own_begin});
  if (near.other == invalid_index) near.other = face_at(point, {own_end, from(groups_[own].end)});
  return near.other != invalid_index;
}

}  // namespace whittle::detail
