#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "complex/areas_of_faces.hh"
#include "complex/triangle_complex.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses contractions that would take the last face of an area (`seam_areas`): a chart, or a piece of a region.
///
/// Each area has a witness: its first face that is left. An area can only end where a contraction takes its witness, so
/// nothing is looked at but the areas whose witness has both vertices of the pair. Faces that are gone stay gone, so
/// the search for the next witness goes on where the last one ended.
class AreaGuard final : public Guard {
 public:
  /// \param areas must outlive the guard
  AreaGuard(TriangleComplex& complex, const AreasOfFaces& areas);

  std::optional<Refusal> reason() const override { return Refusal::area; }
  bool refuses(ContractionProfile& profile) override;
  bool follows() const override { return true; }
  void note(const Change& change) override;
  bool is_final() const override { return true; }  // an area gets no faces
  bool gives_way() override {
    const bool was_given_up = is_given_up_;
    is_given_up_ = may_give_up_;
    return may_give_up_ && !was_given_up;
  }

 private:
  /// Those of a face, as vertices of the complex now.
  Triangle corners(Index face);
  bool ends_with(Index area, const Pair& pair);
  void watch(Index area);

  TriangleComplex& complex_;
  std::span<const Triangle> faces_;
  std::vector<Index> slots_;                               ///< by the vertices of `faces_`, those of the complex
  std::vector<Index> members_;                             ///< the faces of all areas, by area
  std::vector<std::size_t> first_;                         ///< of each area, its witness in `members_`, or its end
  std::vector<std::size_t> ends_;                          ///< of each area, in `members_`
  std::unordered_map<Index, std::vector<Index>> watched_;  ///< by vertex of the complex: areas with a witness there
  bool may_give_up_;
  bool is_given_up_ = false;
};

}  // namespace whittle
