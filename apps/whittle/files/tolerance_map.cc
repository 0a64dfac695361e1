#include "files/tolerance_map.hh"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "options/values.hh"
#include "whittle/io/errors.hh"

namespace whittle::app {
namespace {

double parse_tolerance(const std::string& path, std::uint64_t line_number, std::string line, double diagonal) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.pop_back();
  try {
    const double tolerance = parse_length(line, "T").in_units(diagonal);
    if (tolerance > 0) return tolerance;
  } catch (const std::invalid_argument&) {
    // is said below, with the line
  }
  throw io::ReadError(path, {.line = line_number}, "'" + line + "' is no length above 0");
}

}  // namespace

std::vector<double> read_tolerance_map(const std::string& path, const io::ReadResult& read, double diagonal) {
  std::ifstream file(path);
  if (!file) throw io::ReadError(path, std::strerror(errno));
  std::vector<double> tolerances(read.mesh.positions.size(), std::numeric_limits<double>::infinity());
  std::uint64_t n_lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (n_lines++ >= read.vertex_map.size()) continue;
    const double tolerance = parse_tolerance(path, n_lines, std::move(line), diagonal);
    const Index vertex = read.vertex_map[n_lines - 1];
    if (vertex != invalid_index) tolerances[vertex] = std::min(tolerances[vertex], tolerance);
  }
  if (file.bad()) throw io::ReadError(path, std::strerror(errno));
  if (n_lines == read.vertex_map.size()) return tolerances;
  throw io::ReadError(path, "it has " + std::to_string(n_lines) + " lines for the " +
                                std::to_string(read.vertex_map.size()) + " vertices of the mesh's file");
}

}  // namespace whittle::app
