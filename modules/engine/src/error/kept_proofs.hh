#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Proofs of faces of the input, and the faces of the surface that each is by: it holds until one of these changes.
class KeptProofs {
 public:
  /// \param face greater than those before
  void add(Index face, std::span<const Index> by) {
    faces_.push_back(face);
    by_.insert(by_.end(), by.begin(), by.end());
    ends_.push_back(by_.size());
  }

  /// Goes through proofs in the order of their faces.
  class Reader {
   public:
    explicit Reader(const KeptProofs& proofs) : proofs_(proofs) {}

    /// Goes on to a face, which is greater than those before. \return whether it has a proof
    bool find(Index face) {
      while (at_ < proofs_.faces_.size() && proofs_.faces_[at_] < face) ++at_;
      return at_ < proofs_.faces_.size() && proofs_.faces_[at_] == face;
    }
    /// \pre find
    std::span<const Index> by() const {
      const std::size_t begin = at_ == 0 ? 0 : proofs_.ends_[at_ - 1];
      return std::span(proofs_.by_).subspan(begin, proofs_.ends_[at_] - begin);
    }

   private:
    const KeptProofs& proofs_;
    std::size_t at_ = 0;
  };

 private:
  std::vector<Index> faces_;
  std::vector<std::size_t> ends_;  ///< in `by_`
  std::vector<Index> by_;
};

}  // namespace whittle
