#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace whittle::bench {

/// What the certifier and independent measures say of a result. Distances are those of all points, both ways, over E.
struct Proof {
  double certified = 0;             ///< what is proven of the surfaces
  double found = 0;                 ///< of the point that the certifier calls the farthest, as `FaceTree` measures it
  double sampled = 0;               ///< the largest at samples
  std::optional<double> by_cgal{};  ///< by CGAL, to a 100th of E
  std::optional<double> borders{};  ///< as `certified`, if there are borders
  std::optional<double> sampled_borders{};  ///< as `sampled`
  bool has_same_bytes = true;               ///< the result and its certificate, on 1, 2 and 3 threads
  std::size_t certificate_bytes = 0;        ///< 0 = there is none
  bool holds = false;                       ///< whether the verifier takes the certificate
};

/// Seconds, medians of the rounds.
struct TimeBeside {
  double with_limit = 0;  ///< `simplify` with a length as target
  double plain = 0;       ///< to the same number of faces
  double ratio = 0;       ///< median of single rounds
};

/// What a proof of a given pair takes, beside making the pair. Seconds, medians of the rounds.
struct PairTimes {
  double simplify = 0;
  double certify = 0;
  double certify_by_map = 0;  ///< with the vertex map of the run that made the result
  double certificate = 0;     ///< to prove it and to write the steps
  double verify = 0;
};

/// A mesh and a result within E of it.
struct Row {
  std::string mesh;
  std::size_t n_input = 0;  ///< faces
  double error_rel = 0;     ///< E over the diagonal
  std::size_t n_faces = 0;  ///< of the result
  std::optional<Proof> proof{};
  std::optional<std::size_t> level{};  ///< faces of the best level without guard
  /// Faces of each contender's coarsest result; none if it has none.
  std::vector<std::optional<std::size_t>> contenders{};
  std::optional<TimeBeside> time{};
  std::optional<PairTimes> pair{};  ///< a result with a tenth of the faces; E is 1.01 times its largest distance
  std::vector<std::string> violations{};
  std::vector<std::string> remarks{};  ///< why something is missing
};

}  // namespace whittle::bench
