#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Sources and headers: maps a path relative to the project, with slashes, to the text.
using SourceTree = std::map<std::string, std::string>;

/// All files with one of the extensions under `folders` of `root`.
/// \throw std::runtime_error if a folder contains none
SourceTree read_source_tree(const std::filesystem::path& root, const std::vector<std::string>& folders,
                            const std::set<std::string>& extensions = {".cc", ".hh"});

/// One `#include`, or import, of a file of the project.
struct Include {
  std::string from;
  std::string to;  ///< empty: no file of the tree has the name in quotes
  std::string name;
};

/// The `#include`s with quotes and of `<whittle/…>`, resolved as the compiler does, and the imports from other files of
/// JavaScript. Generated headers are left out.
std::vector<Include> includes_of(const SourceTree& tree);

/// The folder of a path; "" for a file at the top.
std::string folder_of(const std::string& path);
