// Replays the corpora of the fuzzers: no input breaks a promise. Then mutations of small files of every format. Each
// gives an error or a valid mesh, and no single allocation is larger than the file justifies. The environment variables
// WHITTLE_FUZZ_RUNS and WHITTLE_FUZZ_SEED ask for more runs and other seeds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz/largest_allocation.hh"
#include "fuzz/mutate.hh"
#include "fuzz/seed_files.hh"
#include "fuzz/targets.hh"
#include "support/random.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::stoull(text) : otherwise;
}

/// The bytes of every file of a corpus, by name. \throw std::runtime_error if there is none
std::map<std::string, std::string> corpus(std::string_view target) {
  std::map<std::string, std::string> inputs;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(WHITTLE_FUZZ_CORPUS) / target)) {
    std::ifstream file(entry.path(), std::ios::binary);
    inputs[entry.path().filename().string()] = std::string(std::istreambuf_iterator<char>(file), {});
  }
  if (inputs.empty()) throw std::runtime_error("no corpus of " + std::string(target));
  return inputs;
}

class FuzzCorpus : public testing::TestWithParam<NamedTarget> {};

TEST_P(FuzzCorpus, KeepsItsPromises) {
  for (const auto& [name, bytes] : corpus(GetParam().name)) EXPECT_NO_THROW(GetParam().run(bytes)) << name;
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, testing::ValuesIn(library_targets()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FuzzIo, EveryMutationGivesAnErrorOrAValidMesh) {
  const std::uint64_t runs = from_environment("WHITTLE_FUZZ_RUNS", 300);
  const std::uint64_t first_seed = from_environment("WHITTLE_FUZZ_SEED", 1);
  const std::vector<SeedFile> files = seed_files();
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
      Random random(seed * 1000 + f);
      std::string file = mutated(files[f].bytes, random);
      if (random.below(16) == 0) file += files[random.below(files.size())].bytes.substr(1);
      // Vectors grow by doubling. A position takes 24 bytes in memory, and possibly only three in the file. Buffers
      // take 1 MiB.
      const std::size_t justified = 64 * file.size() + (std::size_t{1} << 20);
      largest_allocation = 0;
      try {
        fuzz_reader(file, files[f].format);
      } catch (const std::exception& error) {
        FAIL() << error.what() << ": file " << f << ", seed " << seed << "\n" << file;
      }
      ASSERT_LE(largest_allocation, justified) << "file " << f << ", seed " << seed << "\n" << file;
    }
  }
}

// Mutations need valid files to start from.
TEST(FuzzIo, EverySeedIsAValidFile) {
  for (const SeedFile& file : seed_files()) {
    const std::string_view bytes = std::string_view(file.bytes).substr(1);
    EXPECT_NO_THROW(io::read_mesh(bytes, "seed", {.format = file.format})) << bytes;
  }
}

}  // namespace
}  // namespace whittle::test
