// Damaged files: refused in one line, or read. Sanitizers watch (preset asan).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "assets.hh"
#include "fuzz/mutate.hh"
#include "scene_builder.hh"
#include "support/random.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/gltf/pose.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using whittle::test::Random;

constexpr std::size_t n_mutations = 10'000;
constexpr std::size_t largest_file = 40'000;

/// Small assets of all kinds, as they are, and as GLB, which has the bytes of all buffers.
std::vector<std::string> small_files() {
  std::vector<std::string> files;
  for (const auto& file : asset_files({"gltf-tiny", "gltf-quirky", "gltf-reject"})) {
    std::string bytes = bytes_of_file(file);
    try {
      std::string glb = Asset::read(file).write_glb();
      if (glb.size() < largest_file) files.push_back(std::move(glb));
    } catch (const io::ReadError&) {
    }
    if (!bytes.empty() && bytes.size() < largest_file) files.push_back(std::move(bytes));
  }
  return files;
}

/// A whole number of the document becomes another one that is likely to do harm.
std::string with_another_number(std::string file, Random& random) {
  static const std::vector<std::string> numbers = {"0",  "1",     "2",          "3",     "4",
                                                   "-1", "65536", "4294967295", "1e300", "5121"};
  const std::size_t end = std::min(file.size(), file.find(std::string("BIN\0", 4)));
  const std::size_t at = file.find_first_of("0123456789", random.below(end));
  if (at < end) file.replace(at, file.find_first_not_of("0123456789", at) - at, numbers[random.below(numbers.size())]);
  return file;
}

/// The size in the header of a GLB, and in that of its document, as they should be: what is behind them is looked at.
void repair_sizes(std::string& file, std::size_t old_size) {
  if (!is_glb(file) || file.size() < 20) return;
  const auto put = [&](std::size_t at, std::size_t value) {
    for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<char>(value >> (8 * i) & 0xFFU);
  };
  const auto byte = [&](std::size_t at) { return std::size_t{static_cast<unsigned char>(file[at])}; };
  put(8, file.size());
  put(12, byte(12) + (byte(13) << 8U) + (byte(14) << 16U) + file.size() - old_size);
}

/// Poses scenes that are small: what is damaged may name a mesh, or an instance, any number of times.
void pose(const Asset& asset) {
  constexpr std::size_t most_triangles = 100'000;
  std::size_t n = 0;
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) n += asset.n_triangles(m) * asset.n_instances(m);
  if (n > most_triangles) return;
  const Poser poser(asset);
  poser.mesh(poser.rest());
  for (const AnimationTime& moment : poser.moments(3)) poser.mesh(poser.animated(moment));
  poser.mesh(poser.artificial(0));
}

void read_and_write(std::string bytes) {
  Asset asset = Asset::read(std::move(bytes), "input");
  pose(asset);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    asset.world_transforms(m);
    asset.set_triangles(m, asset.triangles(m));
  }
  asset.write_glb();
}

/// Damages files in turn, and reads, poses and writes them.
void expect_refused_or_read(const std::vector<std::string>& files, std::uint64_t seed) {
  Random random(seed);
  std::size_t n_refused = 0;
  for (std::size_t i = 0; i < n_mutations; ++i) {
    const std::string& file = files[i % files.size()];
    std::string damaged =
        random.below(2) == 0 ? whittle::test::mutated(file, random) : with_another_number(file, random);
    if (random.below(2) == 0) repair_sizes(damaged, file.size());
    try {
      read_and_write(damaged);
    } catch (const io::ReadError& error) {
      ++n_refused;
      ASSERT_THAT(error.what(), Not(HasSubstr("\n"))) << "mutation " << i;
    } catch (const std::exception& error) {
      FAIL() << "mutation " << i << " of file " << i % files.size() << ": " << error.what();
    }
  }
  EXPECT_GT(n_refused, n_mutations / 4);
  EXPECT_LT(n_refused, n_mutations * 19 / 20);
}

TEST(GltfMutations, AreRefusedInOneLineOrRead) {
  const std::vector<std::string> files = small_files();
  WHITTLE_NEEDS_ASSETS(files);
  expect_refused_or_read(files, 7);
}

TEST(GltfMutations, OfScenesThatMoveAreRefusedInOneLineOrPosed) {
  SceneBuilder bent = bar();
  bent.animate(2, "rotation", {0, 1, 2}, bent.fractions("VEC4", {0, 0, 0, 32767, 0, 0, 23170, 23170, 1, 2, 3, 4}));
  SceneBuilder morphing = morphing_triangle();
  morphing.animate(0, "weights", {0, 1}, morphing.floats("SCALAR", {0, 0, 1, 0, 0, 0, 0, 0, 3, 1, 0, 0}),
                   "CUBICSPLINE");
  expect_refused_or_read({bent.glb(), morphing.glb(), bar().glb(), morphing_triangle().glb()}, 8);
}

}  // namespace
}  // namespace whittle::gltf::test
