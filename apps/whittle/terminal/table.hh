#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "whittle/core/text/text.hh"

namespace whittle::app {

/// Rows of cells in columns with two spaces between them. The first column is left-aligned, the others are
/// right-aligned. An empty row is an empty line.
class Table {
 public:
  void add(std::vector<std::string> row);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string yes_no(bool value);
/// "51,200"
std::string grouped(std::uint64_t n);

}  // namespace whittle::app
