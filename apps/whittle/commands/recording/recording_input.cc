#include "commands/recording/recording_input.hh"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "terminal/errors.hh"
#include "terminal/table.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/errors.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::app {
namespace {

using progressive::Recording;

Recording read_recording_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw io::ReadError(path, std::string("cannot be opened: ") + std::strerror(errno));
  try {
    return progressive::read_recording(file);
  } catch (const progressive::RecordingError& error) {
    throw io::ReadError(path, error.what());
  }
}

/// The mesh that the run began with.
IndexedMesh input_of(const RecordingInput& options, const FileOptions& files, unsigned threads, const Talk& talk,
                     Recording& recording) {
  if (!options.input) {
    if (recording.input) return std::move(*recording.input);
    throw UsageError(options.path + " doesn't have the mesh that was simplified: name it with --input");
  }
  FileOptions as_then = files;
  const bool has_scene = reads_gltf(*options.input, files);
  for (const bool reads_scene : {false, true}) {  // what a run reads of glTF depends on its output
    if (reads_scene && !has_scene) break;
    as_then.reads_scene = reads_scene;
    const Talk once = reads_scene ? Talk(Volume::quiet) : talk;
    IndexedMesh mesh = as_recorded(read_input(*options.input, as_then, threads, once).read.mesh);
    if (progressive::content_hash(mesh) == recording.hash) return mesh;
    mesh.normals.clear();  // as with --attributes position-only
    mesh.colors.clear();
    if (progressive::content_hash(mesh) == recording.hash) return mesh;
  }
  throw io::ReadError(*options.input, "is not the mesh of " + options.path +
                                          ", or is read otherwise: --weld and --no-weld have to be as they were");
}

[[noreturn]] void refuse_level(const RecordingInput& options, const progressive::Replay& replay,
                               const std::string& asked) {
  throw std::runtime_error(options.path + ": its last level has more than " + asked + ": " +
                           faces_text(replay.n_faces()) + " and " + vertices_text(replay.n_vertices()));
}

}  // namespace

IndexedMesh as_recorded(IndexedMesh mesh) {
  drop_seams(mesh);
  mesh.attributes.clear();
  mesh.face_attributes.clear();
  mesh.face_groups.clear();
  mesh.group_names.clear();
  return mesh;
}

void add_recording(CLI::App& app, RecordingInput& options) {
  add_file(app, "REC", options.path, "what 'simplify --record' has written")->type_name("FILE");
}

void add_recording_input(CLI::App& app, RecordingInput& options) {
  add_value(
      app, "--input", "FILE", options.input, [](std::string_view text) { return std::string(text); },
      "the mesh that was simplified, for a recording that was written with --no-embed")
      ->default_str("the one in REC");
}

Json recording_json(const RecordingFacts& facts) {
  return {{"path", facts.path},
          {"embedded", facts.is_embedded},
          {"vertices", facts.n_vertices},
          {"faces", facts.n_faces},
          {"contractions", facts.n_contractions}};
}

void check_recording_outputs(const RecordingInput& options, const std::vector<std::string>& meshes,
                             const std::vector<Output>& outputs, const FileOptions& files,
                             const CommonOptions& common) {
  std::vector<std::string> inputs;
  if (options.input) inputs.push_back(*options.input);
  check_formats(inputs, meshes, files);
  inputs.push_back(options.path);
  check_outputs(outputs, inputs, common.force);
}

progressive::Replay read_replay(const RecordingInput& options, const FileOptions& files, unsigned threads,
                                const Talk& talk, RecordingFacts& facts) {
  Recording recording = read_recording_file(options.path);
  facts = {options.path, recording.input.has_value(), recording.n_vertices, recording.n_faces,
           recording.steps.contractions.size()};
  IndexedMesh mesh = input_of(options, files, threads, talk, recording);
  try {
    return {std::move(mesh), std::move(recording.steps), recording.normals};
  } catch (const std::invalid_argument& error) {
    throw io::ReadError(options.path, error.what());
  }
}

std::size_t level_of_faces(const RecordingInput& options, const progressive::Replay& replay, std::uint64_t n_faces) {
  const std::optional<std::size_t> level = replay.level_of_faces(n_faces);
  if (!level) refuse_level(options, replay, faces_text(n_faces));
  return *level;
}

std::size_t level_of_vertices(const RecordingInput& options, const progressive::Replay& replay,
                              std::uint64_t n_vertices) {
  const std::optional<std::size_t> level = replay.level_of_vertices(n_vertices);
  if (!level) refuse_level(options, replay, vertices_text(n_vertices));
  return *level;
}

}  // namespace whittle::app
