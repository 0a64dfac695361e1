#pragma once

#include <map>
#include <string>

#include "page_bytes.hh"
#include "whittle/report/page.hh"

namespace whittle::report {

/// The image files of a page, each once.
class PageImages {
 public:
  /// \return the number of the image
  std::size_t number_of(const Image& image);
  /// {"type", "bytes"} each
  Json pack(PageBytes& bytes) const;

 private:
  std::map<std::string_view, std::size_t> numbers_;  ///< by bytes, which the images hold
  std::vector<std::string_view> files_;
};

/// Null where the mesh has nothing beside its shape. Otherwise {"wedges", "count", "texcoords", "normals", "colours",
/// "linear", "materials", "groups", "coarse_groups", "maps"}:
/// - "wedges": the vertex of each wedge above the vertices; the first ones are the vertices
/// - "texcoords": sets that are shown, [{"name", "values"}]: two 32-bit numbers a wedge, in 65,536ths
/// - "normals": an octahedral map of two 16-bit numbers a wedge; "colours": four bytes a wedge, sRGB. Or null.
///   "linear": whether colours are interpolated as light
/// - "materials": [{"name", "colour", "image", "texcoords", "transform", "wrap", "alpha", "cutoff"}]; "groups": the
///   number of each face's material, 16 bits; "coarse_groups" the same of the coarse faces. Faces without one have the
///   last one, which is plain
/// - "maps": [{"name", "kind", "max", "usual", "values"}], a byte a wedge (`packed_value`)
Json pack_look(const PageSurface& surface, PageBytes& bytes, PageImages& images);

}  // namespace whittle::report
