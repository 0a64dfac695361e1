#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "complex/contraction_profile.hh"

namespace whittle {

/// How a vertex lies in the surface. An edge is regular when it has exactly two faces.
enum class VertexKind : std::uint8_t {
  regular,   ///< one closed fan of faces
  line,      ///< one open fan: an inner vertex of a border, or of a line of irregular edges
  junction,  ///< anything else: bow-ties, meeting lines
};

/// The link of one vertex or of a pair: its neighbours, and how its faces connect them.
class Link {
 public:
  /// A neighbour.
  struct Entry {
    Index vertex;
    std::array<Index, 2> n_faces{};                           ///< at its edges to the first and to the second vertex
    std::array<Index, 2> next{invalid_index, invalid_index};  ///< slots of up to two neighbours in the link
    Index n_ahead = 0;                                        ///< number of faces (v, this, ...) that begin with it
    Index ahead = invalid_index;                              ///< slot of the third corner of the last of them
    bool is_opposite = false;                                 ///< a corner of a face of the pair

    /// The slot that a walk along the link reaches from here.
    Index beyond(Index previous) const { return next[0] == previous ? next[1] : next[0]; }
  };

  explicit Link(std::size_t n_vertices = 0) : slots_(n_vertices) {}

  void clear() { entries_.clear(); }
  /// Slot of v among the entries; v is added if it isn't there.
  Index slot(Index v);
  Entry& operator[](Index slot) { return entries_[slot]; }
  std::span<const Entry> entries() const { return entries_; }

  /// Of a vertex. \param faces at it
  void gather(std::span<const LinkEdge> faces);
  /// \param pairs the same faces, two neighbours each
  void gather(std::span<const Neighbour> pairs);

  VertexKind kind() const;
  /// Whether all faces run the same way along the link. \pre it is one closed polygon
  bool is_oriented() const;
  /// The vertex at `slot` of an oriented polygon; goes on to the next, counter-clockwise.
  Index step(Index& slot) const;
  /// Number of fans: sets of faces that are connected over edges at the vertex.
  std::size_t n_fans();

 private:
  void connect_faces();

  std::vector<Entry> entries_;
  std::vector<Index> slots_;     ///< by vertex; right only if the entry there names the vertex
  std::vector<LinkEdge> faces_;  ///< of the vertex gathered
  std::vector<Index> fan_;       ///< scratch
};

}  // namespace whittle
