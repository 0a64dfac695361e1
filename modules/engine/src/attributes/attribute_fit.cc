// Attributes of a simplified mesh, fitted to those of its input:
//
//   minimise  Σ_s m_s |Σ_k b_sk x_sk − a_s|²  +  λ Σ_w M_w |x_w − x⁰_w|²
//
// s are samples of the input, one in each face, with the face's area m_s and its attributes a_s there. b_sk and x_sk
// are the barycentric coordinates of the nearest point of the result, and the values at the corners there. x⁰_w is what
// the input has nearest to the wedge's vertex, M_w = Σ m_s b_sk. Both nearest points are looked for in the same chart.
// The normal equations are solved by conjugate gradients.
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "attributes/attribute_blend.hh"
#include "attributes/region_trees.hh"
#include "attributes/regions.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/attributes.hh"

namespace whittle {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Foot = RegionTrees::Foot;

constexpr double guess_weight = 0.02;  ///< λ

/// Whether shading may break where the attribute has two values.
bool breaks_anywhere(AttributeKind kind) {
  return kind == AttributeKind::normal || kind == AttributeKind::tangent || kind == AttributeKind::direction;
}
/// How many of the first components are blended by sums.
std::size_t n_linear(const Attribute& attribute) {
  switch (attribute.kind) {
    case AttributeKind::category:
    case AttributeKind::joint_weights:
      return 0;
    case AttributeKind::tangent:
      return std::min<std::size_t>(attribute.n_components, 3);
    default:
      return attribute.n_components;
  }
}

/// Normals and colours like any other attribute, as far as `result` has them.
std::vector<Attribute> all_attributes(const IndexedMesh& mesh, const IndexedMesh& result) {
  std::vector<Attribute> all = mesh.attributes;
  const auto add = [&](AttributeKind kind, const auto& values, bool is_there) {
    if (!is_there) return;
    Attribute& attribute = all.emplace_back();
    attribute.kind = kind;
    attribute.n_components = values.front().size();
    for (const auto& value : values) attribute.values.insert(attribute.values.end(), value.begin(), value.end());
  };
  add(AttributeKind::normal, mesh.normals, !result.normals.empty());
  add(AttributeKind::color, mesh.colors, !result.colors.empty());
  return all;
}

template <std::size_t N>
void take_last(std::vector<Attribute>& all, std::vector<std::array<float, N>>& values) {
  if (values.empty()) return;
  for (std::size_t w = 0; w < values.size(); ++w) {
    const std::span<const double> value = std::as_const(all.back()).value(w);
    for (std::size_t i = 0; i < N; ++i) values[w][i] = static_cast<float>(value[i]);
  }
  all.pop_back();
}

/// The fit of those attributes that may have two values in the same places.
class AttributeFit {
 public:
  AttributeFit(const IndexedMesh& input, const IndexedMesh& mesh, std::span<const Index> face_origins, Break at,
               unsigned threads)
      : input_(input),
        mesh_(mesh),
        threads_(threads),
        input_regions_(surface_regions(input, at)),
        regions_(face_origins.size()) {
    for (std::size_t f = 0; f < regions_.size(); ++f) regions_[f] = input_regions_[face_origins[f]];
    find_feet();
    find_samples();
    assemble();
  }

  /// \param from of the input \param to of the mesh
  void fit(const Attribute& from, Attribute& to) const;

 private:
  void find_feet();
  void find_samples();
  void assemble();
  void guess(const Attribute& from, Attribute& to) const;
  Eigen::VectorXd right_side(const Attribute& from, std::size_t component) const;

  const IndexedMesh& input_;
  const IndexedMesh& mesh_;
  unsigned threads_;
  std::vector<Index> input_regions_;
  std::vector<Index> regions_;  ///< of the faces of the mesh
  std::vector<Foot> feet_;      ///< on the input, of each wedge
  std::vector<Foot> samples_;   ///< on the mesh, of the middle of each face of the input
  std::vector<double> areas_;   ///< of the faces of the input
  Matrix matrix_;
  Eigen::VectorXd guess_weights_;  ///< λ M
};

void AttributeFit::find_feet() {
  const RegionTrees trees(input_, input_regions_);
  struct Place {
    Index vertex, region;
  };
  std::vector<Place> places(n_wedges(mesh_), {invalid_index, invalid_index});
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) places[mesh_.wedge(f, k)] = {mesh_.faces[f][k], regions_[f]};
  }
  feet_.resize(places.size());
  for_each_range(places.size(), threads_, [&](std::size_t begin, std::size_t end) {
    Foot hint;
    for (std::size_t w = begin; w < end; ++w) {
      if (places[w].vertex == invalid_index) continue;
      hint = feet_[w] = trees.nearest(places[w].region, mesh_.positions[places[w].vertex], hint);
    }
  });
}

void AttributeFit::find_samples() {
  const RegionTrees trees(mesh_, regions_);
  samples_.resize(input_.faces.size());
  areas_.resize(input_.faces.size());
  for_each_range(input_.faces.size(), threads_, [&](std::size_t begin, std::size_t end) {
    Foot hint;
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = input_.faces[f];
      const Vec3& p = input_.positions[a];
      const Vec3& q = input_.positions[b];
      const Vec3& r = input_.positions[c];
      areas_[f] = (q - p).cross(r - p).norm() / 2;
      samples_[f] = trees.nearest(input_regions_[f], (p + q + r) / 3, hint);
      if (samples_[f].face != invalid_index) hint = samples_[f];
    }
  });
}

void AttributeFit::assemble() {
  const auto n = static_cast<Eigen::Index>(feet_.size());
  std::vector<std::array<double, 9>> of_faces(mesh_.faces.size(), std::array<double, 9>{});
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(n);
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const auto& [face, weights] = samples_[s];
    if (face == invalid_index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      masses[mesh_.wedge(face, i)] += areas_[s] * weights[i];
      for (std::size_t k = 0; k < 3; ++k) of_faces[face][3 * i + k] += areas_[s] * weights[i] * weights[k];
    }
  }
  const double mean = masses.mean();
  guess_weights_ = guess_weight * masses.array() + 1e-6 * (mean > 0 ? mean : 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * of_faces.size() + feet_.size());
  for (std::size_t f = 0; f < of_faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        entries.emplace_back(static_cast<int>(mesh_.wedge(f, i)), static_cast<int>(mesh_.wedge(f, k)),
                             of_faces[f][3 * i + k]);
      }
    }
  }
  for (int w = 0; w < n; ++w) entries.emplace_back(w, w, guess_weights_[w]);
  matrix_.resize(n, n);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

/// What the input has nearest to each wedge.
void AttributeFit::guess(const Attribute& from, Attribute& to) const {
  AttributeBlend blend(from.kind, from.n_components);
  for (std::size_t w = 0; w < feet_.size(); ++w) {
    const auto& [face, weights] = feet_[w];
    if (face == invalid_index) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[k] > 0) blend.add(from.value(input_.wedge(face, k)), weights[k]);
    }
    blend.result(to.value(w));
  }
}

Eigen::VectorXd AttributeFit::right_side(const Attribute& from, std::size_t component) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(feet_.size()));
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const auto& [face, weights] = samples_[s];
    if (face == invalid_index) continue;
    double middle = 0;
    for (std::size_t k = 0; k < 3; ++k) middle += from.value(input_.wedge(s, k))[component] / 3;
    for (std::size_t k = 0; k < 3; ++k) sums[mesh_.wedge(face, k)] += areas_[s] * weights[k] * middle;
  }
  return sums;
}

/// Of unit length again, or in [0, 1]. A value that has no length stays as it was before the fit.
void restore_range(AttributeKind kind, std::span<const double> before, std::span<double> value) {
  if (kind == AttributeKind::color) {
    for (double& x : value) x = std::clamp(x, 0.0, 1.0);
  } else if (kind == AttributeKind::normal || kind == AttributeKind::tangent) {
    const double length = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    for (std::size_t i = 0; i < 3; ++i) value[i] = length > 1e-3 ? value[i] / length : before[i];
  }
}

void AttributeFit::fit(const Attribute& from, Attribute& to) const {
  guess(from, to);
  const Attribute before = to;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-5);
  solver.setMaxIterations(50);
  solver.compute(matrix_);
  for (std::size_t i = 0; i < n_linear(from); ++i) {
    Eigen::VectorXd start(static_cast<Eigen::Index>(feet_.size()));
    for (std::size_t w = 0; w < feet_.size(); ++w) start[static_cast<Eigen::Index>(w)] = before.value(w)[i];
    const Eigen::VectorXd sums = right_side(from, i) + guess_weights_.cwiseProduct(start);
    const Eigen::VectorXd fitted = solver.solveWithGuess(sums, start);
    for (std::size_t w = 0; w < feet_.size(); ++w) to.value(w)[i] = fitted[static_cast<Eigen::Index>(w)];
  }
  for (std::size_t w = 0; w < feet_.size(); ++w) restore_range(from.kind, before.value(w), to.value(w));
}

}  // namespace

void fit_attributes(const IndexedMesh& input, std::span<const Index> face_origins, Normals normals, IndexedMesh& mesh,
                    unsigned threads) {
  std::vector<Attribute> from = all_attributes(input, mesh);
  std::vector<Attribute> to = all_attributes(mesh, mesh);
  for (const bool may_break : {false, true}) {
    const auto is_fitted = [&](const Attribute& attribute) {
      const bool is_recomputed = attribute.kind == AttributeKind::normal && normals != Normals::keep;
      return breaks_anywhere(attribute.kind) == may_break && !is_recomputed;
    };
    if (std::none_of(to.begin(), to.end(), is_fitted)) continue;
    const AttributeFit fit(input, mesh, face_origins, may_break ? Break::any_wedge : Break::seam, threads);
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (is_fitted(to[i])) fit.fit(from[i], to[i]);
    }
  }
  take_last(to, mesh.colors);
  take_last(to, mesh.normals);
  mesh.attributes = std::move(to);
}

}  // namespace whittle
