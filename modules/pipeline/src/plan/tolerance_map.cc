#include "plan/tolerance_map.hh"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/pipeline/values.hh"
#include "whittle/scene/errors.hh"

namespace whittle {
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

/// \param of_file of each vertex of the file
std::vector<double> of_mesh(const io::ReadResult& read, const std::vector<double>& of_file) {
  std::vector<double> tolerances(read.mesh.positions.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < of_file.size(); ++v) {
    const Index vertex = read.vertex_map[v];
    if (vertex != invalid_index) tolerances[vertex] = std::min(tolerances[vertex], of_file[v]);
  }
  return tolerances;
}

}  // namespace

std::vector<double> tolerances_of_file(const io::ReadResult& read, const std::string& name) {
  const auto bad = std::find_if_not(read.tolerances.begin(), read.tolerances.end(), [](double t) { return t > 0; });
  if (bad == read.tolerances.end()) return read.tolerances.empty() ? read.tolerances : of_mesh(read, read.tolerances);
  throw UnsupportedMesh(name + ": vertex " + std::to_string(bad - read.tolerances.begin()) +
                        ", counted from 0, has the tolerance " + shortest(*bad) +
                        "; with --max-error all must be above 0, or come from --tolerance-map");
}

std::vector<double> read_tolerance_map(const std::string& path, const io::ReadResult& read, double diagonal) {
  std::ifstream file(io::path_of(path));
  if (!file) throw io::ReadError(path, std::strerror(errno));
  std::vector<double> of_file;
  std::uint64_t n_lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (n_lines++ >= read.vertex_map.size()) continue;
    of_file.push_back(parse_tolerance(path, n_lines, std::move(line), diagonal));
  }
  if (file.bad()) throw io::ReadError(path, std::strerror(errno));
  if (n_lines == read.vertex_map.size()) return of_mesh(read, of_file);
  throw io::ReadError(path, "it has " + std::to_string(n_lines) + " lines for the " +
                                std::to_string(read.vertex_map.size()) + " vertices of the mesh's file");
}

}  // namespace whittle
