#include "structure/unbuilt.hh"

#include <filesystem>

namespace {

bool is_built(const std::filesystem::path& test, const SourceTree& scripts) {
  for (std::filesystem::path folder = test.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    const auto script = scripts.find((folder / "CMakeLists.txt").generic_string());
    if (script == scripts.end()) continue;
    const std::string name = test.lexically_relative(folder).generic_string();
    return script->second.find(name) != std::string::npos || script->second.find("GLOB") != std::string::npos;
  }
  return false;
}

}  // namespace

Findings unbuilt_tests(const SourceTree& tree, const SourceTree& scripts) {
  Findings findings;
  for (const auto& [path, text] : tree) {
    if (path.ends_with("_test.cc") && !is_built(path, scripts)) findings.push_back(path);
  }
  return findings;
}
