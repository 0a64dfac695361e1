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

/// What every recording begins with.
inline constexpr std::string_view recording_signature{"\x89WHR\r\n\x1a\n", 8};

/// Of 128 bits: equal for meshes that are the same in all, to the bit.
using ContentHash = std::array<std::uint64_t, 2>;
ContentHash content_hash(const IndexedMesh& mesh);

/// What else belongs to a run, such as the names of groups: texts by a name. They mean something to programs alone.
using RecordingNotes = std::map<std::string, std::vector<std::string>>;

/// A run that was written down.
struct Recording {
  std::optional<IndexedMesh> input;  ///< with all its attributes; none where it was not embedded
  ContentHash hash{};                ///< of the input
  std::uint64_t n_vertices = 0;      ///< of the input
  std::uint64_t n_faces = 0;         ///< of the input
  Normals normals = Normals::keep;   ///< what the run did with them
  std::string about;                 ///< what its writer says of it: text in UTF-8
  RecordingNotes notes;              ///< without empty lists
  RunSteps steps;
};

/// What is said besides the steps.
struct RecordingOptions {
  bool embed = true;      ///< the input
  bool compress = false;  ///< with zstd; std::runtime_error if the library was built without it
  unsigned threads = 0;   ///< 0 = all cores; the file doesn't depend on it
  RecordingNotes notes{};
};

/// A recording that is damaged or not complete, or none at all. `what()` says where, and what is wrong.
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// \param out gets the bytes in order; its state says whether all could be written
/// \param about at most a million bytes, as each name of the mesh and each text of the notes;
///        \throw std::invalid_argument for more
void write_recording(std::ostream& out, const IndexedMesh& input, const RunSteps& steps, Normals normals,
                     std::string_view about = {}, const RecordingOptions& options = {});

/// Reads from the first byte to the last, in order. Memory grows with what is read, not with what the file says of
/// itself. Whether the steps can be made is for `Replay` to find out. \throw RecordingError
Recording read_recording(std::istream& in);

}  // namespace whittle::progressive
