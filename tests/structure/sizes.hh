#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "structure/layers.hh"

/// The definition of a function, or another outermost block of statements, such as a test.
struct FunctionSize {
  std::string name;  ///< the text before its parentheses
  std::size_t first_line;
  std::size_t n_lines;  ///< from the first line of its declaration to its last brace
};

/// All functions of a file. Counts braces in the text without comments and literals, so it needs no compiler.
std::vector<FunctionSize> function_sizes(const std::string& text);

std::size_t n_lines(const std::string& text);

/// "path: name has N lines, from line L" for functions over `limit` lines.
Findings long_functions(const SourceTree& tree, std::size_t limit);

/// Headers over `limit` lines.
Findings long_headers(const SourceTree& tree, std::size_t limit);

/// Folders with more than `limit` sources and headers.
Findings full_folders(const SourceTree& tree, std::size_t limit);
