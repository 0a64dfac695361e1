#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Sources and headers: maps a path relative to the project, with slashes, to the text.
using SourceTree = std::map<std::string, std::string>;

/// All `.cc` and `.hh` files under `folders` of `root`.
/// \throw std::runtime_error if a folder contains none
SourceTree read_source_tree(const std::filesystem::path& root, const std::vector<std::string>& folders);

/// One `#include` of a file of the project.
struct Include {
  std::string from;
  std::string to;  ///< empty: no file of the tree has the name in quotes
  std::string name;
};

/// The `#include`s with quotes and of `<whittle/…>`, resolved as the compiler does. Generated headers are left out.
std::vector<Include> includes_of(const SourceTree& tree);

/// The folder of a path; "" for a file at the top.
std::string folder_of(const std::string& path);
