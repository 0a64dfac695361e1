#include "whittle/polish/fit_attributes.hh"

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "attributes/attribute_samples.hh"
#include "attributes/texture_folds.hh"
#include "whittle/core/attribute_blend.hh"
#include "whittle/core/attribute_functions.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/keep_in_charts.hh"
#include "whittle/core/local_functions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

using polishing::AttributeSamples;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

// Conjugate gradients: few are enough, as the matrix is like one of masses.
constexpr int most_steps = 50;
constexpr double least_residual = 1e-5;  ///< over the right side

constexpr double guess_weight = 0.02;  ///< λ

/// The corners of a mesh as wedges, and where these are: the surface, cut open at its seams.
IndexedMesh cut_open(const IndexedMesh& mesh) {
  IndexedMesh cut;
  cut.positions.resize(n_wedges(mesh), Vec3::Zero());
  cut.faces.resize(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index w = cut.faces[f][k] = mesh.wedge(f, k);
      cut.positions[w] = mesh.positions[mesh.faces[f][k]];
    }
  }
  return cut;
}

/// Values of an attribute: of the original, and of the mesh, to be fitted.
struct Values {
  AttributeKind kind;
  std::size_t n_components;
  std::vector<double> from, to;

  /// n_linear(kind) per wedge of the mesh; without a linear function the slope is 0.
  std::vector<LocalFunction> functions;
  std::vector<Index> maps;  ///< of texture coordinates, as `AttributeFunctions::maps`

  std::span<const double> original(Index w) const { return {from.data() + w * n_components, n_components}; }
  std::span<double> fitted(Index w) { return {to.data() + w * n_components, n_components}; }
};

/// Sums in one order, unlike library functions with wide registers.
double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Vector product(const Matrix& matrix, const Vector& x) {
  Vector y = Vector::Zero(x.size());
  for (Eigen::Index row = 0; row < x.size(); ++row) {
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry) y[row] += entry.value() * x[entry.col()];
  }
  return y;
}

/// Solves matrix · x = b by conjugate gradients with the diagonal as preconditioner. \cite saad_2003_iterative (9.2)
/// \param x from where to start
Vector solved(const Matrix& matrix, const Vector& b, Vector x) {
  const Vector diagonal = matrix.diagonal();
  Vector residual = b - product(matrix, x);
  Vector scaled = residual.cwiseQuotient(diagonal);
  Vector direction = scaled;
  double size = dot(residual, scaled);
  const double enough = least_residual * least_residual * dot(b, b);
  for (int step = 0; step < most_steps && dot(residual, residual) > enough; ++step) {
    const Vector image = product(matrix, direction);
    const double length = size / dot(direction, image);
    x += length * direction;
    residual -= length * image;
    scaled = residual.cwiseQuotient(diagonal);
    const double next_size = dot(residual, scaled);
    direction = scaled + next_size / size * direction;
    size = next_size;
  }
  return x;
}

class AttributeFit {
 public:
  /// \param whole the original \param original, mesh cut open
  AttributeFit(const IndexedMesh& whole, const IndexedMesh& original, std::span<const Index> wedge_map,
               const IndexedMesh& mesh, unsigned threads);

  void fit(Values& values) const;
  /// Removes folds, and moves faces off other charts.
  /// \return number of folded faces left
  /// \pre texture coordinates, fitted
  std::size_t lay_on_image(Values& values) const;

 private:
  template <class Use>
  void for_each_sample(const Use& use) const;
  void assemble();
  void find_functions(const AttributeFunctions& functions, Values& values) const;
  void guess(const AttributeFunctions& functions, Values& values) const;
  std::vector<double> right_sides(const Values& values) const;
  void keep_in_range(Values& values) const;
  bool holds_everywhere(const Values& values) const;
  void set_functions_that_hold(Values& values) const;
  std::vector<std::uint8_t> linear_wedges(Values& values) const;

  const IndexedMesh& original_;
  const IndexedMesh& mesh_;
  unsigned threads_;
  Frame frame_;
  std::vector<Vec3> positions_;  ///< of the mesh, in the frame
  LocalFunctions functions_;
  AttributeSamples samples_;
  Matrix matrix_;
  Vector guess_weights_;  ///< λ M
};

AttributeFit::AttributeFit(const IndexedMesh& whole, const IndexedMesh& original, std::span<const Index> wedge_map,
                           const IndexedMesh& mesh, unsigned threads)
    : original_(original),
      mesh_(mesh),
      threads_(threads),
      frame_(Frame::of_points(original.positions)),
      functions_(whole, frame_, wedge_map, mesh.positions.size(), threads) {
  const detail::Workers workers(threads);
  const polishing::OriginalSurface surface(original, workers);
  const polishing::Origins origins(surface, wedge_map, mesh.positions.size(), 1, workers);
  positions_.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) positions_.push_back(frame_.to_frame(p));
  const polishing::VertexCorners corners = polishing::corners_by_vertex(mesh.faces, mesh.positions.size());
  samples_ = find_attribute_samples(origins, {mesh.faces, corners, positions_}, workers);
  assemble();
}

/// Calls `use(sample, wedges of the original, weights at the corners of the closest point's face)`. The value at a
/// sample is the mean over these wedges.
template <class Use>
void AttributeFit::for_each_sample(const Use& use) const {
  const auto tell = [&](const AttributeSamples::Sample& sample, std::span<const Index> wedges) {
    if (sample.closest.face == invalid_index || !(sample.weight > 0)) return;
    const double second = sample.closest.second;
    const double third = sample.closest.third;
    use(sample, wedges, std::array<double, 3>{1 - second - third, second, third});
  };
  for (Index w = 0; w < samples_.of_vertices.size(); ++w) tell(samples_.of_vertices[w], {&w, 1});
  for (std::size_t f = 0; f < samples_.of_faces.size(); ++f) tell(samples_.of_faces[f], original_.faces[f]);
}

void AttributeFit::assemble() {
  const auto n = static_cast<Eigen::Index>(mesh_.positions.size());
  std::vector<std::array<double, 9>> of_faces(mesh_.faces.size(), std::array<double, 9>{});
  Vector masses = Vector::Zero(n);
  for_each_sample([&](const AttributeSamples::Sample& sample, std::span<const Index>, const std::array<double, 3>& at) {
    const auto& [closest, weight, wedge] = sample;
    const Index face = closest.face;
    for (std::size_t i = 0; i < 3; ++i) {
      masses[mesh_.faces[face][i]] += weight * at[i];
      for (std::size_t k = 0; k < 3; ++k) of_faces[face][3 * i + k] += weight * at[i] * at[k];
    }
  });
  const double mean = dot(masses, Vector::Ones(n)) / static_cast<double>(n);
  guess_weights_ = guess_weight * masses.array().max(0) + 1e-6 * (mean > 0 ? mean : 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * of_faces.size() + mesh_.positions.size());
  for (std::size_t f = 0; f < of_faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        entries.emplace_back(static_cast<int>(mesh_.faces[f][i]), static_cast<int>(mesh_.faces[f][k]),
                             of_faces[f][3 * i + k]);
      }
    }
  }
  for (int w = 0; w < n; ++w) entries.emplace_back(w, w, guess_weights_[w]);
  matrix_.resize(n, n);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

void AttributeFit::find_functions(const AttributeFunctions& functions, Values& values) const {
  const std::size_t n = n_linear(values.kind, values.n_components);
  values.functions.resize(n * positions_.size());
  for_each_range(positions_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (auto w = static_cast<Index>(begin); w < end; ++w) {
      if (!functions.any(w)) continue;
      const std::vector<LocalFunction> around = functions.of(w);
      for (std::size_t i = 0; i < n; ++i) {
        LocalFunction& function = values.functions[w * n + i];
        function = around[i];
        if (!function.is_linear) function.slope.setZero();
      }
    }
  });
}

/// The original's value at each wedge's closest point, extrapolated to the wedge.
void AttributeFit::guess(const AttributeFunctions& functions, Values& values) const {
  AttributeBlend blend(values.kind, values.n_components);
  const std::size_t n = n_linear(values.kind, values.n_components);
  for (Index w = 0; w < samples_.of_wedges.size(); ++w) {
    const polishing::SurfacePoint& nearest = samples_.of_wedges[w];
    if (nearest.face == invalid_index) continue;
    const auto& [second, third] = nearest.at;
    const std::array<double, 3> at{1 - second - third, second, third};
    Vec3 closest = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = original_.faces[nearest.face][k];
      if (at[k] > 0) blend.add(values.original(from), at[k]);
      closest += at[k] * frame_.to_frame(original_.positions[from]);
    }
    blend.result(values.fitted(w));
    if (values.kind == AttributeKind::joint_weights) functions.move(w, positions_[w], values.fitted(w));
    for (std::size_t i = 0; i < n; ++i) {
      values.fitted(w)[i] += values.functions[w * n + i].gain(positions_[w] - closest);
    }
  }
}

/// Right-hand sides for the first n_linear components, a row for each wedge. A sample's value is extrapolated to its
/// closest point.
std::vector<double> AttributeFit::right_sides(const Values& values) const {
  const std::size_t n = n_linear(values.kind, values.n_components);
  std::vector<double> sums(n * mesh_.positions.size());
  std::vector<double> value(n);
  for_each_sample(
      [&](const AttributeSamples::Sample& sample, std::span<const Index> wedges, const std::array<double, 3>& at) {
        const Triangle& face = mesh_.faces[sample.closest.face];
        const double share = 1 / static_cast<double>(wedges.size());
        Vec3 to_closest = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k) to_closest += at[k] * positions_[face[k]];
        std::fill(value.begin(), value.end(), 0.0);
        for (const Index w : wedges) {
          to_closest -= share * frame_.to_frame(original_.positions[w]);
          for (std::size_t i = 0; i < n; ++i) value[i] += share * values.original(w)[i];
        }
        for (std::size_t i = 0; i < n; ++i) value[i] += values.functions[sample.wedge * n + i].gain(to_closest);
        for (std::size_t k = 0; k < 3; ++k) {
          double* const sum = sums.data() + n * face[k];
          for (std::size_t i = 0; i < n; ++i) sum[i] += at[k] * (sample.weight * value[i]);
        }
      });
  return sums;
}

/// Clamps values to the original's range around the wedge and its neighbours. The range around the wedge alone is too
/// narrow for the best fit where values curve.
void AttributeFit::keep_in_range(Values& values) const {
  const std::size_t n = n_linear(values.kind, values.n_components);
  for (std::size_t i = 0; i < n; ++i) {
    const auto function = [&](Index w) -> const LocalFunction& { return values.functions[w * n + i]; };
    std::vector<LocalFunction> wide;
    for (Index w = 0; w < positions_.size(); ++w) wide.push_back(function(w));
    for (const auto& [a, b, c] : mesh_.faces) {
      if (!functions_.any(a) || !functions_.any(b) || !functions_.any(c)) continue;
      const double low = std::min({function(a).low, function(b).low, function(c).low});
      const double high = std::max({function(a).high, function(b).high, function(c).high});
      for (const Index w : {a, b, c}) wide[w].low = std::min(wide[w].low, low);
      for (const Index w : {a, b, c}) wide[w].high = std::max(wide[w].high, high);
    }
    for (Index w = 0; w < positions_.size(); ++w) {
      double& number = values.fitted(w)[i];
      if (functions_.any(w)) number = wide[w].in_range(number, positions_[w]);
    }
  }
}

/// Whether all numbers follow functions of whole charts, so that nothing is left to fit.
bool AttributeFit::holds_everywhere(const Values& values) const {
  const std::size_t n = n_linear(values.kind, values.n_components);
  for (Index w = 0; w < positions_.size(); ++w) {
    if (!functions_.any(w)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      if (!values.functions[w * n + i].holds) return false;
    }
  }
  return true;
}

/// A number that is linear throughout its chart is so here, too: the fit would see the rounding of single values.
void AttributeFit::set_functions_that_hold(Values& values) const {
  const std::size_t n = n_linear(values.kind, values.n_components);
  for (Index w = 0; w < positions_.size(); ++w) {
    for (std::size_t i = 0; i < n; ++i) {
      const LocalFunction& function = values.functions[w * n + i];
      if (function.holds) values.fitted(w)[i] = function.at(positions_[w]);
    }
  }
}

/// A column of a table with rows of n numbers.
auto column(std::vector<double>& table, std::size_t i, std::size_t n) {
  using Stride = Eigen::InnerStride<>;
  return Eigen::Map<Vector, 0, Stride>(table.data() + i, static_cast<Eigen::Index>(table.size() / n),
                                       Stride(static_cast<Eigen::Index>(n)));
}

void AttributeFit::fit(Values& values) const {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  const bool is_fitted = std::all_of(values.from.begin(), values.from.end(),
                                     is_finite);  // one value that isn't finite would spread to all
  const AttributeFunctions functions(functions_, values.kind, values.n_components, values.from, threads_);
  find_functions(functions, values);
  guess(functions, values);
  if (values.kind == AttributeKind::texcoord) values.maps = functions.maps();
  const std::vector<double> guessed = values.to;
  const std::size_t n = values.n_components;
  const std::size_t n_fitted = is_fitted ? n_linear(values.kind, n) : 0;
  if (n_fitted > 0 && !holds_everywhere(values)) {
    std::vector<double> sides = right_sides(values);
    for_each_block(n_fitted, threads_, [&](std::size_t i) {
      const Vector start = column(values.to, i, n);
      const Vector side = column(sides, i, n_fitted) + guess_weights_.cwiseProduct(start);
      // Subtract the mean: a large one would make every relative residual look small.
      const Vector level =
          Vector::Constant(start.size(), dot(start, Vector::Ones(start.size())) / static_cast<double>(start.size()));
      column(values.to, i, n) = level + solved(matrix_, side - product(matrix_, level), start - level);
    });
    keep_in_range(values);
  }
  set_functions_that_hold(values);
  for (Index w = 0; w < mesh_.positions.size(); ++w) {
    restore_range(values.kind, {guessed.data() + w * n, n}, values.fitted(w));
  }
}

/// Wedges whose numbers are linear in the position, and so are here: where the image folds, the surface does.
std::vector<std::uint8_t> AttributeFit::linear_wedges(Values& values) const {
  constexpr double nearly = 1e-3;  // share of a number's variation: the rounding of files
  const std::size_t n = n_linear(values.kind, values.n_components);
  std::vector<std::uint8_t> is_linear(positions_.size(), 1);
  for (Index w = 0; w < positions_.size(); ++w) {
    for (std::size_t i = 0; i < n; ++i) {
      const LocalFunction& function = values.functions[w * n + i];
      const double apart = std::abs(values.fitted(w)[i] - function.at(positions_[w]));
      if (!function.is_linear || !(apart <= nearly * (function.high - function.low))) is_linear[w] = 0;
    }
  }
  return is_linear;
}

std::size_t AttributeFit::lay_on_image(Values& values) const {
  const auto turns =
      turns_on_image({original_.faces, values.from, values.n_components}, samples_.of_faces, mesh_.faces.size());
  const std::size_t n_folded =
      polishing::unfold(mesh_.faces, turns, values.to, values.n_components, linear_wedges(values));
  keep_in_charts({functions_.input(), values.from, functions_.wedge_map(), values.n_components, mesh_.faces,
                  values.maps, threads_},
                 values.to);
  return n_folded;
}

template <std::size_t N>
void fit_array(const AttributeFit& fit, AttributeKind kind, const std::vector<std::array<float, N>>& from,
               std::vector<std::array<float, N>>& to) {
  Values values{kind, N, {}, {}, {}, {}};
  for (const auto& value : from) values.from.insert(values.from.end(), value.begin(), value.end());
  for (const auto& value : to) values.to.insert(values.to.end(), value.begin(), value.end());
  fit.fit(values);
  for (std::size_t i = 0; i < N * to.size(); ++i) to[i / N][i % N] = static_cast<float>(values.to[i]);
}

void check_map(const IndexedMesh& original, std::span<const Index> wedge_map, const IndexedMesh& mesh) {
  check_attributes(original, "fit_attributes");
  check_attributes(mesh, "fit_attributes");
  const auto require = [](bool is_so, const char* what) {
    if (!is_so) throw std::invalid_argument(std::string("fit_attributes: ") + what);
  };
  require(wedge_map.size() == n_wedges(original), "wedge_map has another length than the original's wedges");
  const std::size_t n = n_wedges(mesh);
  require(std::all_of(wedge_map.begin(), wedge_map.end(), [n](Index w) { return w == invalid_index || w < n; }),
          "wedge_map names a wedge that isn't there");
  require(mesh.attributes.size() == original.attributes.size(), "the meshes have other attributes");
}

}  // namespace

AttributeFitReport fit_attributes(const IndexedMesh& original, std::span<const Index> wedge_map, IndexedMesh& mesh,
                                  const FitAttributesOptions& options) {
  const bool fits_normals = options.fit_normals && !original.normals.empty() && !mesh.normals.empty();
  const bool fits_colors = !original.colors.empty() && !mesh.colors.empty();
  AttributeFitReport report;
  if (!fits_normals && !fits_colors && original.attributes.empty()) return report;
  check_map(original, wedge_map, mesh);
  if (original.faces.empty() || mesh.faces.empty()) return report;
  const IndexedMesh cut_original = cut_open(original);
  const IndexedMesh cut_mesh = cut_open(mesh);
  const AttributeFit fit(original, cut_original, wedge_map, cut_mesh, options.threads);
  if (fits_normals) fit_array(fit, AttributeKind::normal, original.normals, mesh.normals);
  if (fits_colors) fit_array(fit, AttributeKind::color, original.colors, mesh.colors);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    Attribute& attribute = mesh.attributes[i];
    Values values{
        attribute.kind, attribute.n_components, original.attributes[i].values, std::move(attribute.values), {}, {}};
    fit.fit(values);
    const bool is_texture = values.kind == AttributeKind::texcoord && values.n_components >= 2;
    if (is_texture) report.n_folded_faces += fit.lay_on_image(values);
    attribute.values = std::move(values.to);
  }
  return report;
}

}  // namespace whittle
