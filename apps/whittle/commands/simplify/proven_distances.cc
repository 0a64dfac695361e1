#include "commands/simplify/proven_distances.hh"

#include <cmath>

#include "terminal/point_text.hh"
#include "terminal/table.hh"

namespace whittle::app {
namespace {

/// "asked: at most 0.1 (0.5 %) off, borders 0.05 (0.25 %)"
std::string asked_line(const DistancesAsWritten& distances, const DecimateTarget& target, double diagonal) {
  std::string line = "asked: at most " + length_text_rounded_up(*target.error_limit(), diagonal) + " off";
  if (!distances.borders) return line;
  return line + ", borders " + length_text_rounded_up(*target.border_error_limit(), diagonal);
}

/// "at 1 2 3, in face 7; 12 faces have corners nearly as far"
std::string place_text(const metrics::LargestDistance& largest, double diagonal, const char* one, const char* several) {
  return "at " + point_text(largest.where.point, diagonal) + ", in face " + std::to_string(largest.where.face) + "; " +
         (largest.n_far_faces == 1 ? "1 " + std::string(one) : std::to_string(largest.n_far_faces) + ' ' + several) +
         " nearly as far";
}

/// "in.ply is at most 0.1 (0.5 %) off out.ply, at least 0.0999 (0.4995 %): "
std::string distance_text(const std::string& from, const std::string& to, const metrics::LargestDistance& largest,
                          double diagonal) {
  return from + " is at most " + length_text_rounded_up(largest.at_most, diagonal) + " off " + to + ", and " +
         length_text(largest.at_least, diagonal) + ' ';
}

std::string surface_line(const std::string& from, const std::string& to, const metrics::LargestDistance& largest,
                         double diagonal) {
  return distance_text(from, to, largest, diagonal) +
         place_text(largest, diagonal, "face has corners", "faces have corners");
}

std::string border_line(const std::string& from, const std::string& to, const metrics::LargestDistance& largest,
                        double diagonal) {
  if (!std::isfinite(largest.at_most)) return from + " has a border, " + to + " has none";
  return distance_text("the border of " + from, "that of " + to, largest, diagonal) +
         place_text(largest, diagonal, "border edge has ends", "border edges have ends");
}

}  // namespace

std::vector<std::string> distance_lines(const DistancesAsWritten& distances, const DecimateTarget& target,
                                        const NamesOfRun& names) {
  const auto& [in, out, diagonal] = names;
  std::vector<std::string> lines;
  if (target.error_limit()) lines.push_back(asked_line(distances, target, diagonal));
  lines.push_back(surface_line(in, out, distances.surface.forward, diagonal));
  lines.push_back(surface_line(out, in, distances.surface.backward, diagonal));
  if (!distances.borders) return lines;
  const auto& [forward, backward] = *distances.borders;
  if (forward.where.face != invalid_index) lines.push_back(border_line(in, out, forward, diagonal));
  if (backward.where.face != invalid_index) lines.push_back(border_line(out, in, backward, diagonal));
  return lines;
}

}  // namespace whittle::app
