#include "structure/source_tree.hh"

#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

SourceTree read_source_tree(const fs::path& root, const std::vector<std::string>& folders,
                            const std::set<std::string>& extensions) {
  SourceTree tree;
  for (const std::string& folder : folders) {
    const std::size_t n_before = tree.size();
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !extensions.contains(entry.path().extension().string())) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      tree[entry.path().lexically_relative(root).generic_string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
    if (tree.size() == n_before) throw std::runtime_error("no sources under " + (root / folder).string());
  }
  return tree;
}

namespace {

const std::set<std::string> generated_headers = {"whittle/version.hh"};

/// The folders that `#include "name"` is looked up in, for a file of the tree.
std::vector<std::string> include_folders(const SourceTree& tree, const std::string& from) {
  std::vector<std::string> folders = {folder_of(from)};
  std::set<std::string> modules;
  for (const auto& [path, text] : tree)
    if (path.starts_with("modules/")) modules.insert(path.substr(0, path.find('/', 8)));
  for (const std::string& module : modules) {
    const std::string unit_tests = "tests/unit" + module.substr(module.find('/')) + "/";
    const bool sees_all = from.starts_with("tests/fuzz/") || from.starts_with("tests/oracle/");
    if (from.starts_with(module + "/") || from.starts_with(unit_tests) || sees_all) folders.push_back(module + "/src");
    folders.push_back(module + "/include");
  }
  folders.insert(folders.end(), {"apps/whittle", "tests"});
  return folders;
}

std::string resolve(const SourceTree& tree, const std::vector<std::string>& folders, const std::string& name) {
  for (const std::string& folder : folders) {
    const std::string path = fs::path(folder + "/" + name).lexically_normal().generic_string();
    if (tree.contains(path)) return path;
  }
  return {};
}

}  // namespace

std::vector<Include> includes_of(const SourceTree& tree) {
  static const std::regex directive(
      R"re(^\s*#\s*include\s+(?:"([^"]+)"|<(whittle/[^>]+)>)|^\s*(?:import|export)\s.*from\s+'(\.[^']+)')re");
  std::vector<Include> includes;
  for (const auto& [path, text] : tree) {
    const std::vector<std::string> folders = include_folders(tree, path);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      const bool may_match = line.find("include") != std::string::npos || line.find("port") != std::string::npos;
      if (!may_match || !std::regex_search(line, match, directive)) continue;
      const std::string name = match[1].matched ? match[1] : match[2].matched ? match[2] : match[3];
      if (!generated_headers.contains(name)) includes.push_back({path, resolve(tree, folders, name), name});
    }
  }
  return includes;
}
