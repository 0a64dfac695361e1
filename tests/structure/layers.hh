#pragma once

#include <set>
#include <string>
#include <vector>

#include "structure/source_tree.hh"

/// One row of layers.txt.
struct Layer {
  std::string name;
  std::vector<std::string> folders;
  std::set<std::string> uses;  ///< names of earlier rows
};

/// The rows of layers.txt. That file explains its format.
/// \throw std::runtime_error for a row in another format, or that uses a later row or itself
std::vector<Layer> read_layers(const std::string& text);

/// Errors that a check found, one line each; empty: none.
using Findings = std::vector<std::string>;

/// Includes from a layer to one that it may not use, files without a layer, and includes of files that don't exist.
Findings forbidden_includes(const SourceTree& tree, const std::vector<Layer>& layers);

/// Folders of the table that contain no file.
Findings idle_rows(const SourceTree& tree, const std::vector<Layer>& layers);

/// Include cycles: "a -> b -> a".
Findings include_circles(const SourceTree& tree);
