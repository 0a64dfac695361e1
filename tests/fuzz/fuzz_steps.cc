#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fuzz/check/promise.hh"
#include "fuzz/decode/mesh_bytes.hh"
#include "fuzz/targets.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/progressive/geomorph.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::test {
namespace {

using progressive::Replay;

/// Steps that a run may or may not make of the mesh.
RunSteps decode_steps(ByteSource& source, const IndexedMesh& mesh) {
  RunSteps steps;
  const auto n_vertices = static_cast<unsigned>(std::clamp<std::size_t>(mesh.positions.size() + 1, 1, 256));
  const auto n_faces = static_cast<unsigned>(std::clamp<std::size_t>(mesh.faces.size() + 1, 1, 256));
  const auto position = [&]() -> Vec3 {
    if (source.one_in(20)) return {source.any_real(), 0, 0};
    return {source.real(-1, 1), source.real(-1, 1), source.real(-1, 1)};
  };
  while (!source.is_empty()) {
    if (!source.one_in(8)) {
      const Index survivor = source.below(n_vertices);
      const Index removed = source.below(n_vertices);
      const bool is_pair = source.one_in(2);
      steps.contractions.push_back({survivor, removed, position(), source.real(0, 1), is_pair, source.one_in(2)});
      continue;
    }
    PassEnd end;
    end.n_contractions = steps.contractions.size();
    for (int n = source.below(4); n > 0; --n) end.moved.push_back({source.below(n_vertices), position()});
    for (int n = source.below(3); n > 0; --n) {
      end.turned.push_back(
          {source.below(n_faces), {source.below(n_vertices), source.below(n_vertices), source.below(n_vertices)}});
    }
    steps.pass_ends.push_back(std::move(end));
  }
  return steps;
}

/// The steps of a run on the mesh.
RunSteps steps_of_run(const IndexedMesh& mesh) {
  DecimateOptions options;
  options.keep_steps = true;
  options.threads = 1;
  return decimate(mesh, DecimateTarget::faces(1), options).steps;
}

void check_level(const Replay& replay) {
  const Decimation level = replay.decimation();
  const std::size_t n = level.mesh.positions.size();
  require(level.mesh.faces.size() == replay.n_faces() && n == replay.n_vertices(), "a level has the counts it says");
  for (const Triangle& face : level.mesh.faces) {
    require(has_three_corners(face) && *std::max_element(face.begin(), face.end()) < n, "faces have three vertices");
  }
  for (const Vec3& p : level.mesh.positions) require(p.allFinite(), "positions are finite");
  for (const Index v : level.vertex_map) require(v < n || v == invalid_index, "vertices are mapped to vertices");
}

void check_way_back(Replay& replay) {
  replay.go_to(0);
  for (Index v = 0; v < replay.input().positions.size(); ++v) {
    require(std::memcmp(&replay.position(v), &replay.input().positions[v], sizeof(Vec3)) == 0, "the input comes back");
  }
  for (Index f = 0; f < replay.input().faces.size(); ++f) {
    require(replay.corners(f) == replay.input().faces[f], "the input's faces come back");
  }
}

void check_geomorph(Replay& replay) {
  const std::size_t last = replay.n_steps();
  try {
    const progressive::Geomorph geomorph(replay, last / 3, last);
    const IndexedMesh between = geomorph.at(0.5);
    require(between.faces == geomorph.fine().faces, "a geomorph keeps its faces");
    for (const Vec3& p : between.positions) require(p.allFinite(), "positions between are finite");
  } catch (const std::invalid_argument&) {
    require(!replay.steps().pass_ends.empty(), "only flips stand in the way of a geomorph");
  }
}

void check_round_trip(const Replay& replay) {
  std::stringstream file;
  progressive::write_recording(file, replay.input(), replay.steps(), Normals::keep, "fuzz", {.threads = 1});
  progressive::Recording recording = progressive::read_recording(file);
  require(recording.hash == progressive::content_hash(*recording.input), "the mesh has its hash");
  Replay again(std::move(*recording.input), std::move(recording.steps), recording.normals);
  require(again.n_steps() == replay.n_steps(), "all steps are read");
  const IndexedMesh mesh = again.decimation().mesh;
  const IndexedMesh expected = replay.decimation().mesh;
  require(mesh.positions == expected.positions && mesh.faces == expected.faces, "a recording ends as its run did");
}

}  // namespace

void fuzz_steps(std::string_view bytes) {
  ByteSource source(bytes);
  const bool is_run = source.one_in(4);
  IndexedMesh mesh = decode_mesh(source);
  make_finite(mesh);
  try {
    Replay replay(mesh, is_run ? steps_of_run(mesh) : decode_steps(source, mesh));
    check_level(replay);
    check_round_trip(replay);
    replay.go_to(replay.n_steps() / 2);
    check_level(replay);
    check_way_back(replay);
    check_geomorph(replay);
  } catch (const std::invalid_argument& refusal) {
    require(!is_run, "the steps of a run can be made: ", refusal.what());
  }
}

}  // namespace whittle::test
