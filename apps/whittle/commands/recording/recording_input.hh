#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/progressive/replay.hh"

// The recordings that `simplify --record` writes, as inputs of other subcommands.

namespace whittle::app {

/// Options of a recording.
struct RecordingInput {
  std::string path;
  std::optional<std::string> input;                        ///< the mesh of the run, if it is not in the recording
  std::string how_to_name_input = "name it with --input";  ///< what the error says where it is needed
};

/// Key of the input's format, "gltf", in the description of a run by 'simplify --record'.
inline constexpr char input_format_key[] = "input_format";

/// A mesh with one normal and one colour a vertex, and no other attributes.
IndexedMesh with_vertex_attributes(IndexedMesh mesh);

/// The argument REC.
OptionRow recording_argument(RecordingInput& options);
/// --input. \param more end of its help: uses beside a missing mesh
OptionRow recording_input_row(RecordingInput& options, const std::string& more = {});

/// Facts of a recording for the report.
struct RecordingFacts {
  std::string path;
  bool is_embedded = false;                   ///< the input mesh
  std::uint64_t n_vertices = 0, n_faces = 0;  ///< of the input
  std::uint64_t n_contractions = 0;
  io::FileNotes notes;                ///< of the input, for writers of positions
  std::vector<std::string> left_out;  ///< content of the input lost by `read_replay`: "vt", "materials"
};

/// {"path", "embedded", "vertices", "faces", "contractions"}
Json recording_json(const RecordingFacts& facts);

/// `check_formats` and `check_outputs` of a run that reads a recording. \param meshes paths of written meshes
void check_recording_outputs(const RecordingInput& options, const std::vector<std::string>& meshes,
                             const std::vector<Output>& outputs, const FileOptions& files, const CommonOptions& common);

/// A recording whose levels have all attributes.
struct RecordedRun {
  progressive::Replay replay;
  /// The file that --input names; else the recording. Of its mesh, positions and groups alone.
  Input input;
  bool texcoords_grow_down = false;  ///< see `SceneFormat`
};

/// \throw as `read_replay`
RecordedRun read_recorded_run(const RecordingInput& options, const FileOptions& files, unsigned threads,
                              const Talk& talk, RecordingFacts& facts);
/// Levels with one normal and one colour a vertex.
/// \throw UsageError if there is no mesh to begin with; io::ReadError if a file can't be read, is damaged, or if the
///        mesh is another one
progressive::Replay read_replay(const RecordingInput& options, const FileOptions& files, unsigned threads,
                                const Talk& talk, RecordingFacts& facts);

/// \throw std::runtime_error if the last level has more faces
std::size_t level_of_faces(const RecordingInput& options, const progressive::Replay& replay, std::uint64_t n_faces);
/// \throw std::runtime_error if the last level has more vertices
std::size_t level_of_vertices(const RecordingInput& options, const progressive::Replay& replay,
                              std::uint64_t n_vertices);

}  // namespace whittle::app
