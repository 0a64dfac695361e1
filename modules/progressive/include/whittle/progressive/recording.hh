#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/engine/options.hh"
#include "whittle/engine/run_steps.hh"

// A run in a file: the input mesh and the steps of the run. docs/dev/format.md describes the format.

namespace whittle::progressive {

/// The first bytes of every recording.
inline constexpr std::string_view recording_signature{"\x89WHR\r\n\x1a\n", 8};

/// A hash of 128 bits, equal for meshes that are equal to the bit.
using ContentHash = std::array<std::uint64_t, 2>;
ContentHash content_hash(const IndexedMesh& mesh);

/// Further data of a run, such as names of groups: texts by a name. Only programs interpret them.
using RecordingNotes = std::map<std::string, std::vector<std::string>>;

/// A recorded run.
struct Recording {
  std::optional<IndexedMesh> input;  ///< with all its attributes; empty unless embedded
  ContentHash hash{};                ///< of the input
  std::uint64_t n_vertices = 0;      ///< of the input
  std::uint64_t n_faces = 0;         ///< of the input
  Normals normals = Normals::keep;   ///< option of the run
  std::string about;                 ///< the writer's description, UTF-8
  RecordingNotes notes;              ///< without empty lists
  RunSteps steps;
};

struct RecordingOptions {
  bool embed = true;      ///< whether to embed the input
  bool compress = false;  ///< with zstd; std::runtime_error if the library was built without it
  unsigned threads = 0;   ///< 0 = all cores; the file is the same for any number
  RecordingNotes notes{};
};

/// A damaged or incomplete recording, or another file. `what()` gives the place and the problem.
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// \param out gets the bytes in order; its state shows write errors
/// \param about at most a million bytes, like each name of the mesh and each text of the notes
/// \throw std::invalid_argument for longer texts
void write_recording(std::ostream& out, const IndexedMesh& input, const RunSteps& steps, Normals normals,
                     std::string_view about = {}, const RecordingOptions& options = {});

/// Reads from the first byte to the last, in order. Memory grows with the bytes read, not with counts in the file.
/// `Replay` checks whether the steps are possible. \throw RecordingError
Recording read_recording(std::istream& in);

}  // namespace whittle::progressive
