#pragma once

#include <span>
#include <vector>

#include "whittle/core/frame.hh"

namespace whittle {

/// The vertices of a mesh as sites. Vertices at exactly one position are the members of one site, so a search meets
/// the position once, however many there are.
///
/// Sites, and with them their members, are numbered along a space-filling curve. Vertices that are in no face with
/// three different corners are left out.
struct VertexSites {
  Frame frame;
  std::vector<Vec3> points;     ///< of each site, in the frame
  std::vector<Index> begins;    ///< site s has the members begins[s] to begins[s + 1]
  std::vector<Index> sites;     ///< of each member
  std::vector<Index> vertices;  ///< of each member its number in the input, ascending in a site
  std::vector<Index> members;   ///< of each vertex of the input, `invalid_index` of those left out

  std::size_t n_members() const { return vertices.size(); }
};

/// \throw std::invalid_argument for a vertex number out of range, or a coordinate of a member that isn't finite.
VertexSites make_vertex_sites(std::span<const Vec3> positions, std::span<const Triangle> faces, unsigned threads);

}  // namespace whittle
