#include "commands/recording/recording_input.hh"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "commands/recording/recorded_notes.hh"
#include "terminal/errors.hh"
#include "terminal/table.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/whole_file.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::app {
namespace {

using progressive::Recording;

Recording read_recording_file(const std::string& path) {
  std::ifstream file = io::open_file(io::path_of(path), path);
  try {
    return progressive::read_recording(file);
  } catch (const progressive::RecordingError& error) {
    throw io::ReadError(path, error.what());
  }
}

bool is_mesh_of(const Recording& recording, const IndexedMesh& mesh) {
  return progressive::content_hash(mesh) == recording.hash;
}

/// The mesh of a file with the attributes that the run's options kept, if the run began with such a mesh.
std::optional<IndexedMesh> reduced_mesh_of(const Recording& recording, const IndexedMesh& mesh) {
  IndexedMesh reduced = with_vertex_attributes(mesh);
  if (is_mesh_of(recording, reduced)) return reduced;
  reduced.normals.clear();
  reduced.colors.clear();
  if (is_mesh_of(recording, reduced)) return reduced;
  return std::nullopt;
}

/// The notes of the run's file.
io::FileNotes notes_in(const std::string& path, const Recording& recording) {
  try {
    return file_notes_of(recording.notes);
  } catch (const progressive::RecordingError& error) {
    throw io::ReadError(path, error.what());
  }
}

/// The input as described in the recording.
Input input_in_recording(const std::string& path, const Recording& recording) {
  Input input;
  input.path = path;
  input.name = path;
  input.read.notes = notes_in(path, recording);
  const auto name = recording.notes.find(mesh_name_note);
  input.mesh_name = name == recording.notes.end() ? io::path_of(path).filename().stem().string() : name->second.front();
  return input;
}

/// The mesh that the run began with, and the file that it comes from.
std::pair<IndexedMesh, Input> input_of(const RecordingInput& options, const FileOptions& files, unsigned threads,
                                       const Talk& talk, Recording& recording) {
  if (!options.input) {
    if (recording.input) return {std::move(*recording.input), input_in_recording(options.path, recording)};
    throw UsageError(options.path + " doesn't have the mesh that was simplified: " + options.how_to_name_input);
  }
  FileOptions as_then = files;
  const bool has_scene = reads_document(*options.input, files);
  for (const bool reads_scene : {false, true}) {  // a run's scope of glTF depends on its output
    if (reads_scene && !has_scene) break;
    as_then.scope = reads_scene ? SceneScope::scene : SceneScope::meshes;
    const Talk once = reads_scene ? Talk(Volume::quiet) : talk;
    Input input = read_input(*options.input, as_then, threads, once, io::AttributeScope::all);
    IndexedMesh mesh = std::exchange(input.read.mesh, {});
    if (is_mesh_of(recording, mesh)) return {std::move(mesh), std::move(input)};
    if (has_scene && !reads_scene) continue;  // from glTF to glTF a run takes all, or reads the scene
    if (std::optional<IndexedMesh> reduced = reduced_mesh_of(recording, mesh)) {
      input.read.notes = notes_in(options.path, recording);
      return {*std::move(reduced), std::move(input)};
    }
  }
  throw io::ReadError(*options.input,
                      "is not the mesh of " + options.path +
                          ", or is read otherwise (--weld, --no-weld), or the run took parts away (--prune)");
}

/// The format of the run's input, as the recording has it. Empty if it doesn't say.
std::string input_format_of(const Recording& recording) {
  const Json about = Json::parse(recording.about, nullptr, false);
  return about.is_object() ? about.value(input_format_key, std::string()) : std::string();
}

[[noreturn]] void refuse_level(const RecordingInput& options, const progressive::Replay& replay,
                               const std::string& asked) {
  throw std::runtime_error(options.path + ": its last level has more than " + asked + ": " +
                           faces_text(replay.n_faces()) + " and " + vertices_text(replay.n_vertices()));
}

}  // namespace

IndexedMesh with_vertex_attributes(IndexedMesh mesh) {
  drop_seams(mesh);
  mesh.attributes.clear();
  mesh.face_attributes.clear();
  mesh.face_groups.clear();
  mesh.group_names.clear();
  return mesh;
}

OptionRow recording_argument(RecordingInput& options) {
  OptionRow row = file_argument("REC", options.path, "what 'simplify --record' has written");
  row.access.meta = "FILE";
  return row;
}

OptionRow recording_input_row(RecordingInput& options, const std::string& more) {
  OptionRow row =
      side_file_row("--input", options.input,
                    "the mesh that was simplified: for a recording that was written with --no-embed" + more);
  row.standard = "the one in REC";
  return row;
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

namespace {

progressive::Replay replay_of(const std::string& path, IndexedMesh mesh, Recording recording) {
  try {
    return {std::move(mesh), std::move(recording.steps), recording.normals};
  } catch (const std::invalid_argument& error) {
    throw io::ReadError(path, error.what());
  }
}

/// The parts of the input's mesh that writers of levels use.
IndexedMesh frame_of(const IndexedMesh& mesh) {
  IndexedMesh frame;
  frame.positions = mesh.positions;
  frame.face_groups = mesh.face_groups;
  frame.group_names = mesh.group_names;
  return frame;
}

RecordingFacts facts_of(const std::string& path, const Recording& recording) {
  return {path,
          recording.input.has_value(),
          recording.n_vertices,
          recording.n_faces,
          recording.steps.contractions.size(),
          {},
          {}};
}

/// Names of attributes that `with_vertex_attributes` drops.
std::vector<std::string> names_of_left_out(IndexedMesh mesh) {
  std::vector<std::string> names;
  for (const Attribute& attribute : mesh.attributes) names.push_back(attribute.name);
  for (const Attribute& attribute : mesh.face_attributes) names.push_back(attribute.name);
  const auto is_named = [](const std::string& group) { return !group.empty(); };
  if (std::any_of(mesh.group_names.begin(), mesh.group_names.end(), is_named)) names.emplace_back("materials");
  mesh.attributes.clear();
  join_equal_wedges(mesh);
  if (!mesh.wedges.empty()) names.emplace_back("all but one normal and colour of a vertex");
  return names;
}

}  // namespace

RecordedRun read_recorded_run(const RecordingInput& options, const FileOptions& files, unsigned threads,
                              const Talk& talk, RecordingFacts& facts) {
  Recording recording = read_recording_file(options.path);
  facts = facts_of(options.path, recording);
  auto [mesh, input] = input_of(options, files, threads, talk, recording);
  input.read.notes.has_float32_positions = fit_float32(mesh.positions);
  if (!input.document) input.read.mesh = frame_of(mesh);
  const SceneFormat* const format = format_by_extension(input_format_of(recording));
  const bool texcoords_grow_down = format != nullptr && format->texcoords_grow_down;
  return {replay_of(options.path, std::move(mesh), std::move(recording)), std::move(input), texcoords_grow_down};
}

progressive::Replay read_replay(const RecordingInput& options, const FileOptions& files, unsigned threads,
                                const Talk& talk, RecordingFacts& facts) {
  Recording recording = read_recording_file(options.path);
  facts = facts_of(options.path, recording);
  IndexedMesh mesh = input_of(options, files, threads, talk, recording).first;
  facts.notes.has_float32_positions = fit_float32(mesh.positions);
  facts.left_out = names_of_left_out(mesh);
  return replay_of(options.path, with_vertex_attributes(std::move(mesh)), std::move(recording));
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
