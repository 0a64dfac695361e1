#include "whittle/progressive/recording.hh"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "chunks.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/pieces.hh"
#include "whittle/core/wedges.hh"
#include "whittle/progressive/replay.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::progressive {
namespace {

using test::NamedMesh;
using test::Random;

struct RecordedRun {
  IndexedMesh mesh;
  RunSteps steps;
};

/// With all that a recording may have: attributes, threshold pairs, pauses, polish, flips.
RecordedRun run_of(IndexedMesh mesh, bool has_polish) {
  Random random(3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto number = [&random] { return static_cast<float>(random.uniform()); };
    mesh.colors.push_back({number(), number(), number(), 1});
    mesh.normals.push_back({0, 0, 1});
    mesh.origins.push_back(static_cast<Index>(2 * v));
  }
  SimplifyOptions options;
  options.decimate.keep_steps = true;
  options.decimate.normals = Normals::recompute;
  options.decimate.crease_angle_deg = 33.5;
  if (!has_polish) options.decimate.pairs.threshold = std::numeric_limits<double>::infinity();
  const auto target = DecimateTarget::faces(mesh.faces.size() / 5 + 1);
  RunSteps steps = simplify(mesh, target, has_polish ? Effort::best : Effort::fast, options).steps;
  return {std::move(mesh), std::move(steps)};
}

std::string written(const RecordedRun& run, const RecordingOptions& options = {}) {
  std::ostringstream out;
  write_recording(out, run.mesh, run.steps, Normals::recompute, "about", options);
  return std::move(out).str();
}

Recording read(const std::string& bytes) {
  std::istringstream in(bytes);
  return read_recording(in);
}

template <class Item>
void expect_same_bytes(const std::vector<Item>& a, const std::vector<Item>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

void expect_same(const RunSteps& a, const RunSteps& b) {
  EXPECT_EQ(a.crease_angle_deg, b.crease_angle_deg);
  ASSERT_EQ(a.contractions.size(), b.contractions.size());
  for (std::size_t i = 0; i < a.contractions.size(); ++i) {
    const Contraction& x = a.contractions[i];
    const Contraction& y = b.contractions[i];
    EXPECT_EQ(std::tie(x.survivor, x.removed, x.cost, x.is_threshold_pair, x.joins_faces),
              std::tie(y.survivor, y.removed, y.cost, y.is_threshold_pair, y.joins_faces));
    EXPECT_EQ(std::memcmp(&x.position, &y.position, sizeof(Vec3)), 0);
  }
  ASSERT_EQ(a.pass_ends.size(), b.pass_ends.size());
  for (std::size_t i = 0; i < a.pass_ends.size(); ++i) {
    EXPECT_EQ(a.pass_ends[i].n_contractions, b.pass_ends[i].n_contractions);
    ASSERT_EQ(a.pass_ends[i].moved.size(), b.pass_ends[i].moved.size());
    for (std::size_t k = 0; k < a.pass_ends[i].moved.size(); ++k) {
      EXPECT_EQ(a.pass_ends[i].moved[k].vertex, b.pass_ends[i].moved[k].vertex);
      EXPECT_EQ(a.pass_ends[i].moved[k].position, b.pass_ends[i].moved[k].position);
    }
    ASSERT_EQ(a.pass_ends[i].turned.size(), b.pass_ends[i].turned.size());
    for (std::size_t k = 0; k < a.pass_ends[i].turned.size(); ++k) {
      EXPECT_EQ(a.pass_ends[i].turned[k].face, b.pass_ends[i].turned[k].face);
      EXPECT_EQ(a.pass_ends[i].turned[k].corners, b.pass_ends[i].turned[k].corners);
    }
  }
}

TEST(Recording, IsReadAsItWasWritten) {
  for (const NamedMesh& shape : test::all_meshes()) {
    SCOPED_TRACE(shape.name);
    for (const bool has_polish : {false, true}) {
      const RecordedRun run = run_of(shape.mesh, has_polish);
      for (const bool compress : {false, true}) {
        const Recording recording = read(written(run, {true, compress, 1}));
        ASSERT_TRUE(recording.input);
        expect_same_bytes(recording.input->positions, run.mesh.positions);
        expect_same_bytes(recording.input->faces, run.mesh.faces);
        expect_same_bytes(recording.input->normals, run.mesh.normals);
        expect_same_bytes(recording.input->colors, run.mesh.colors);
        expect_same_bytes(recording.input->origins, run.mesh.origins);
        EXPECT_EQ(recording.normals, Normals::recompute);
        EXPECT_EQ(recording.about, "about");
        EXPECT_EQ(recording.hash, content_hash(run.mesh));
        expect_same(recording.steps, run.steps);
      }
      const Recording alone = read(written(run, {false, false, 1}));
      EXPECT_FALSE(alone.input);
      EXPECT_EQ(alone.hash, content_hash(run.mesh));
      EXPECT_EQ(alone.n_vertices, run.mesh.positions.size());
      EXPECT_EQ(alone.n_faces, run.mesh.faces.size());
      expect_same(alone.steps, run.steps);
    }
  }
}

TEST(Recording, KeepsAttributes) {
  for (IndexedMesh mesh : {test::charted_cube(4), test::textured_torus(12, 8)}) {
    mesh.face_attributes.push_back({"label", AttributeKind::category, 2, {}, ScalarType::int16});
    mesh.face_attributes[0].values.resize(2 * mesh.faces.size(), 0.1);
    mesh.attributes.push_back({"weight", AttributeKind::scalar, 1, {}, ScalarType::float64, true});
    mesh.attributes.back().values.resize(n_wedges(mesh), 1.0 / 3);
    SimplifyOptions options;
    options.decimate.keep_steps = true;
    const Simplification result = simplify(mesh, DecimateTarget::faces(mesh.faces.size() / 3), Effort::normal, options);
    const RecordedRun run{mesh, result.steps};
    const Recording recording = read(written(run));
    ASSERT_TRUE(recording.input);
    EXPECT_EQ(recording.input->wedges, mesh.wedges);
    EXPECT_EQ(recording.input->face_groups, mesh.face_groups);
    EXPECT_EQ(recording.input->group_names, mesh.group_names);
    const auto expect_same_attributes = [](const std::vector<Attribute>& a, const std::vector<Attribute>& b) {
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_TRUE(is_same_kind(a[i], b[i])) << a[i].name;
        EXPECT_EQ(std::tie(a[i].type, a[i].is_normalized), std::tie(b[i].type, b[i].is_normalized));
        EXPECT_EQ(a[i].values, b[i].values);
      }
    };
    expect_same_attributes(recording.input->attributes, mesh.attributes);
    expect_same_attributes(recording.input->face_attributes, mesh.face_attributes);
    Replay replay(*recording.input, recording.steps, Normals::keep);
    replay.go_to(replay.n_steps());
    const IndexedMesh level = replay.decimation().mesh;
    EXPECT_EQ(level.wedges, result.mesh.wedges);
    EXPECT_EQ(level.face_groups, result.mesh.face_groups);
    expect_same_attributes(level.attributes, result.mesh.attributes);
    IndexedMesh other = mesh;
    other.attributes[0].values[0] += 1;
    EXPECT_NE(content_hash(other), content_hash(mesh));
  }
}

TEST(Recording, KeepsNotes) {
  const RecordedRun run = run_of(test::octahedron(), false);
  RecordingNotes notes{{"", {""}}, {"names", {"roof", "", std::string("\0\n", 2)}}};
  for (int i = 0; i < 70000; ++i) notes["many"].push_back(std::to_string(i));
  notes["long"] = {std::string(1'000'000, 'a'), "b", std::string(1'000'000, 'c'), std::string(999'999, 'd'), "e"};
  for (const bool embed : {false, true}) {
    EXPECT_EQ(read(written(run, {embed, embed, 2, notes})).notes, notes);
  }
  EXPECT_TRUE(read(written(run)).notes.empty());
  EXPECT_EQ(written(run, {.notes = {{"none", {}}}}), written(run));
  notes["long"].push_back(std::string(1'000'001, 'f'));
  EXPECT_THROW(written(run, {.notes = notes}), std::invalid_argument);
}

TEST(Recording, KeepsEachBitOfCoordinates) {
  RecordedRun run{test::tetrahedron(), {}};
  run.mesh.positions = {{-0.0, 1e-310, 3e150}, {1, 0.1F, -1e30}, {0.1, 0, 0}, {1e-45, 0, 0}};
  run.steps.contractions = {{0, 1, {-0.0, 0.1, 5e-324}, 1e300, true, false}};
  const Recording recording = read(written(run));
  expect_same_bytes(recording.input->positions, run.mesh.positions);
  expect_same(recording.steps, run.steps);
}

TEST(Recording, HasTheSameBytesOnAnyNumberOfThreads) {
  const RecordedRun run = run_of(test::sphere(4), true);
  EXPECT_EQ(written(run, {true, true, 1}), written(run, {true, true, 3}));
}

TEST(Recording, TakesAtMostFortyBytesAContraction) {
  const RecordedRun run = run_of(test::noisy_sphere(5, 0.01, 1), false);
  const std::size_t bytes =
      written(run, {false, false, 1}).size() - written(RecordedRun{run.mesh, {}}, {false, false, 1}).size();
  EXPECT_LE(bytes, 40 * run.steps.contractions.size());
}

TEST(Recording, TakesMoreThanOneChunkForManyElements) {
  DecimateOptions options;
  options.keep_steps = true;
  const IndexedMesh mesh = test::grid(400, 400);
  const RecordedRun run{mesh, decimate(mesh, DecimateTarget::faces(1000), options).steps};
  ASSERT_GT(run.steps.contractions.size(), 65536U);
  const Recording recording = read(written(run));
  expect_same_bytes(recording.input->faces, mesh.faces);
  expect_same(recording.steps, run.steps);
}

TEST(Recording, SaysThatItIsNotComplete) {
  const std::string bytes = written(run_of(test::octahedron(), true));
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_THROW(read(bytes.substr(0, n)), RecordingError) << n;
  EXPECT_THROW(read(bytes + " "), RecordingError);
  EXPECT_NO_THROW(read(bytes));
}

TEST(Recording, SaysThatItIsDamaged) {
  const RecordedRun run = run_of(test::sphere(1), true);
  Random random(5);
  for (const bool compress : {false, true}) {
    const std::string bytes = written(run, {true, compress, 1});
    for (int i = 0; i < 2000; ++i) {
      std::string damaged = bytes;
      char& byte = damaged[random.below(damaged.size())];
      byte = static_cast<char>(byte + static_cast<char>(1 + random.below(255)));
      if (damaged.substr(12, 4) != bytes.substr(12, 4)) continue;  // of no meaning
      EXPECT_THROW(read(damaged), RecordingError) << i;
    }
  }
  const auto message_of = [](const std::string& text) -> std::string {
    try {
      read(text);
    } catch (const RecordingError& error) {
      return error.what();
    }
    return {};
  };
  const std::string whole = written(run);
  const std::string end = framed("END ", "", false);
  const auto message_of_note = [&](const std::string& payload) {
    return message_of(whole.substr(0, whole.size() - end.size()) + framed("note", payload, false) + end);
  };
  EXPECT_EQ(message_of_note("\x01\x01"
                            "a"
                            "\x01"
                            "b"),
            "");
  EXPECT_EQ(message_of_note(std::string("\0\x01"
                                        "a",
                                        3)),
            "it is damaged: a note without texts");
  EXPECT_EQ(message_of_note("\x02\x01"
                            "a"
                            "\x01"
                            "b"),
            "a part of it ends too soon");
  EXPECT_EQ(message_of_note("\x01\x01"
                            "a"
                            "\x7f"
                            "b"),
            "a part of it ends too soon");
  EXPECT_EQ(message_of_note("\x01\x7f"
                            "a"),
            "a part of it ends too soon");
  EXPECT_EQ(message_of_note("\x7f\x01"
                            "a"),
            "it is damaged: a part has too few bytes");
  EXPECT_EQ(message_of_note("\x01\x01"
                            "a"
                            "\x01"
                            "bc"),
            "it is damaged: a part has too many bytes");
  EXPECT_EQ(message_of("ply\nformat ascii 1.0\n"), "it is no recording of whittle");
  EXPECT_EQ(message_of(""), "it is no recording of whittle");
}

/// Chunks whose checks are right, but whose content isn't: what a file of evil intent may hold.
TEST(Recording, IsReadOrRefusedHoweverItsContentIsChanged) {
  std::size_t n_read = 0;
  Random random(9);
  for (const bool has_polish : {false, true}) {
    const RecordedRun run = run_of(test::torus(8, 6), has_polish);
    const std::string bytes = written(run, {.notes = {{"names", {"roof", "", "wall"}}, {"other", {"1"}}}});
    std::vector<Chunk> chunks;
    std::istringstream in(bytes);
    read_signature(in);
    do {
      chunks.push_back(read_chunk(in));
    } while (chunks.back().type != "END ");
    for (int i = 0; i < 5000; ++i) {
      std::vector<Chunk> changed = chunks;
      const std::size_t n_changes = 1 + random.below(3);
      for (std::size_t k = 0; k < n_changes; ++k) {
        Chunk& chunk = changed[random.below(changed.size())];
        const std::size_t way = random.below(8);
        if (way == 0) std::swap(chunk, changed[random.below(changed.size())]);
        if (way == 1) chunk.payload.resize(random.below(chunk.payload.size() + 9));
        if (way >= 2 && !chunk.payload.empty()) {
          chunk.payload[random.below(chunk.payload.size())] = static_cast<char>(random.below(256));
        }
      }
      std::ostringstream out;
      write_signature(out);
      for (const Chunk& chunk : changed) out << framed(chunk.type, chunk.payload, i % 2 == 0);
      try {
        Recording recording = read(out.str());
        Replay replay(std::move(*recording.input), std::move(recording.steps), recording.normals);
        for (const double share : {0.0, 0.7, 0.2, 1.0}) {
          replay.go_to(replay.level_at(share));
          const Decimation level = replay.decimation();
          ASSERT_EQ(level.mesh.faces.size(), replay.n_faces());
          ASSERT_EQ(level.mesh.positions.size(), replay.n_vertices());
        }
        ++n_read;
      } catch (const RecordingError&) {
      } catch (const std::invalid_argument&) {
      }
    }
  }
  EXPECT_GT(n_read, 100U);
}

TEST(Recording, SkipsWhatIsMarkedAsNotNeeded) {
  const RecordedRun run = run_of(test::octahedron(), false);
  std::string bytes = written(run);
  const std::string before_end = bytes.substr(0, bytes.size() - framed("END ", "", false).size());
  const std::string end = bytes.substr(before_end.size());
  EXPECT_NO_THROW(read(before_end + framed("wedg", "whatever", false) + end));
  EXPECT_THROW(read(before_end + framed("UNKN", std::string(1, 0), false) + end), RecordingError);
}

}  // namespace
}  // namespace whittle::progressive
