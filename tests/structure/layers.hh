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

/// The rows of layers.txt, which says how they are written.
/// \throw std::runtime_error for a row that isn't written so, or that uses a later one or itself
std::vector<Layer> read_layers(const std::string& text);

/// What a check found, one line each; empty: nothing.
using Findings = std::vector<std::string>;

/// Includes that go from a layer to one that it may not use, files without a layer, and names that are no file.
Findings forbidden_includes(const SourceTree& tree, const std::vector<Layer>& layers);

/// Folders of the table that no file is in.
Findings idle_rows(const SourceTree& tree, const std::vector<Layer>& layers);

/// Files that include themselves over others: "a -> b -> a".
Findings include_circles(const SourceTree& tree);
