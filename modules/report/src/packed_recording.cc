#include "packed_recording.hh"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace whittle::report {
namespace {

/// Its size is a multiple of four bytes.
struct PackedContraction {
  Index removed;
  std::uint32_t survivor;                 ///< difference from `removed`
  std::array<std::uint16_t, 3> position;  ///< of the survivor: differences from its position in the original
  std::uint16_t n_faces_gone;
};
/// Number of contractions before a pass of polish, and of its changes.
struct PackedEnd {
  std::uint32_t n_contractions, n_moves, n_turns;
};
struct PackedMove {
  Index vertex;
  std::array<std::uint16_t, 4> position;  ///< the last one is 0
};
struct PackedTurn {
  Index face;
  Triangle corners;
};
/// A step hides a face, or shows it again.
struct PackedVisibility {
  std::uint32_t step;
  Index face;
  std::uint32_t is_hidden;
};

/// 0, −1, 1, −2, … as 0, 1, 2, 3, …
template <class Unsigned>
Unsigned difference(Unsigned from, Unsigned to) {
  using Signed = std::make_signed_t<Unsigned>;
  const auto d = static_cast<Signed>(static_cast<Unsigned>(to - from));
  return static_cast<Unsigned>(static_cast<Unsigned>(static_cast<Unsigned>(d) << 1U) ^
                               static_cast<Unsigned>(d < 0 ? ~Unsigned{0} : Unsigned{0}));
}

class RecordingPacker {
 public:
  RecordingPacker(const PageRecording& recording, const Grid& grid)
      : replay_(recording.replay), order_(recording.order), grid_(grid) {}

  Json contractions(PageBytes& bytes) const;
  void add_ends(PageBytes& bytes, Json& json) const;
  Json visibility(PageBytes& bytes) const;

 private:
  Index vertex(Index v) const { return order_.of_vertex[v]; }

  const progressive::Replay& replay_;
  const PageOrder& order_;
  const Grid& grid_;
};

Json RecordingPacker::contractions(PageBytes& bytes) const {
  std::vector<PackedContraction> packed;
  for (std::size_t i = 0; i < replay_.steps().contractions.size(); ++i) {
    const Contraction& contraction = replay_.steps().contractions[i];
    const std::uint64_t n_gone = replay_.n_faces_after(i) - replay_.n_faces_after(i + 1);
    const Index removed = vertex(contraction.removed);
    std::array<std::uint16_t, 3> position = grid_.at(contraction.position);
    const std::array<std::uint16_t, 3> original = grid_.at(replay_.input().positions[contraction.survivor]);
    for (std::size_t d = 0; d < 3; ++d) position[d] = difference(original[d], position[d]);
    packed.push_back({removed, difference(removed, vertex(contraction.survivor)), position,
                      static_cast<std::uint16_t>(std::min<std::uint64_t>(n_gone, 65535))});
  }
  return bytes.add(packed);
}

void RecordingPacker::add_ends(PageBytes& bytes, Json& json) const {
  std::vector<PackedEnd> ends;
  std::vector<PackedMove> moves;
  std::vector<PackedTurn> turns;
  for (const PassEnd& end : replay_.steps().pass_ends) {
    ends.push_back({static_cast<std::uint32_t>(end.n_contractions), static_cast<std::uint32_t>(end.moved.size()),
                    static_cast<std::uint32_t>(end.turned.size())});
    for (const auto& [v, position] : end.moved) {
      const auto [x, y, z] = grid_.at(position);
      moves.push_back({vertex(v), {x, y, z, 0}});
    }
    for (const auto& [face, corners] : end.turned) {
      turns.push_back({order_.of_face[face], {vertex(corners[0]), vertex(corners[1]), vertex(corners[2])}});
    }
  }
  json["ends"] = bytes.add(ends);
  json["moves"] = bytes.add(moves);
  json["turns"] = bytes.add(turns);
}

Json RecordingPacker::visibility(PageBytes& bytes) const {
  std::vector<PackedVisibility> packed;
  for (const progressive::Replay::VisibilityChange& change : replay_.visibility_changes()) {
    packed.push_back(
        {static_cast<std::uint32_t>(change.step), order_.of_face[change.face], change.is_hidden ? 1U : 0U});
  }
  return bytes.add(packed);
}

}  // namespace

Json pack(const PageRecording& recording, const Grid& grid, PageBytes& bytes) {
  const RecordingPacker packer(recording, grid);
  Json json;
  json["steps"] = recording.replay.n_steps();
  json["contractions"] = packer.contractions(bytes);
  packer.add_ends(bytes, json);
  json["visibility"] = packer.visibility(bytes);
  json["levels"] = Json::array();
  for (const PageLevel& level : recording.levels) {
    json["levels"].push_back({{"faces", level.n_faces}, {"mean", level.mean_error}, {"max", level.max_error}});
  }
  return json;
}

}  // namespace whittle::report
