#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/temporary_folder.hh"

// Khronos' validator: npm's package gltf-validator.

namespace whittle::gltf::test {

/// Whether there are Node.js and the validator.
inline bool has_validator() {
  return std::filesystem::is_directory(WHITTLE_NODE_MODULES "/gltf-validator") &&
         std::system("node --version >" WHITTLE_NULL_DEVICE) == 0;
}

/// Pairs of an input and what was made of it.
class Pairs {
 public:
  /// \return where to write what is made of the input
  std::filesystem::path add(const std::filesystem::path& input, const std::string& extension) {
    const std::string name = std::to_string(pairs_.size()) + "_" + input.stem().string() + extension;
    pairs_.emplace_back(input, folder_.path() / name);
    return pairs_.back().second;
  }
  /// Nothing was made.
  void drop_last() { pairs_.pop_back(); }

  bool have_no_new_errors() const {
    const std::filesystem::path list = folder_.path() / "list.txt";
    std::ofstream file(list);
    for (const auto& [input, output] : pairs_) file << input.string() << '\t' << output.string() << '\n';
    file.close();
    const std::string command = "node \"" WHITTLE_NEW_ERRORS "\" \"" WHITTLE_NODE_MODULES "\" \"" + list.string() + '"';
    return std::system(command.c_str()) == 0;
  }

 private:
  whittle::test::TemporaryFolder folder_;
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> pairs_;
};

}  // namespace whittle::gltf::test
