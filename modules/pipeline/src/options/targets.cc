#include "whittle/pipeline/targets.hh"

#include <algorithm>
#include <string>

namespace whittle {

OptionRows target_rows(Targets& targets, const std::string& cost_unit) {
  return {{.names = "--faces",
           .access = count(targets.faces),
           .group = target_group,
           .help = "stop at N faces or fewer, N >= 1"},
          {.names = "--vertices",
           .access = count(targets.vertices),
           .group = target_group,
           .help = "stop at N vertices or fewer, N >= 1"},
          {.names = "-r,--ratio",
           .access = ratio(targets.ratio),
           .group = target_group,
           .help = "keep this share of the vertices, rounded down: 0 < R < 1, or a percentage such as 30%"},
          {.names = "--face-ratio",
           .access = ratio(targets.face_ratio),
           .group = target_group,
           .help = "keep this share of the faces, rounded down: 0 < R < 1, or a percentage such as 30%"},
          {.names = "--max-cost",
           .access = number(targets.max_cost, {0}, "C"),
           .group = target_group,
           .help = "contract nothing that costs more than C, C >= 0; " + cost_unit}};
}

OptionRows error_rows(Targets& targets) {
  return {
      {.names = "-e,--max-error",
       .access = length_above_zero(targets.max_error),
       .group = target_group,
       .help = "fewest faces whose distance to IN, and that of IN to them, is proven to be at most E at all points: "
               "model units, or a percentage of the diagonal such as 0.1%",
       .own_decimater = ""},
      {.names = "--max-error-borders",
       .access = length_above_zero(targets.max_border_error),
       .group = target_group,
       .help = "the same between the open borders of both",
       .standard = "as --max-error",
       .idle = {{.without = {"--max-error"}}}}};
}

DecimateTarget resolve(const Targets& targets, std::uint64_t n_vertices, std::uint64_t n_faces, double diagonal) {
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  if (targets.faces) target = target.or_faces(*targets.faces);
  if (targets.vertices) target = target.or_vertices(*targets.vertices);
  if (targets.max_cost) target = target.or_max_cost(*targets.max_cost);
  if (targets.max_error) {
    const Length of_borders = targets.max_border_error.value_or(*targets.max_error);
    target = target.or_max_error(targets.max_error->in_units(diagonal), of_borders.in_units(diagonal));
  }
  if (targets.ratio) {
    const std::uint64_t kept = share_of(*targets.ratio, n_vertices);
    target = target.or_vertices(std::max(kept, target.n_vertices().value_or(0)));
  }
  if (targets.face_ratio) {
    const std::uint64_t kept = share_of(*targets.face_ratio, n_faces);
    target = target.or_faces(std::max(kept, target.n_faces().value_or(0)));
  }
  return target;
}

bool is_met(const DecimateTarget& target, StopReason stop) {
  const bool has_count = target.n_faces() || target.n_vertices();
  return stop == StopReason::target || (stop != StopReason::cancelled && !has_count);
}

DecimateTarget counts_of(const DecimateTarget& target) {
  DecimateTarget counts = DecimateTarget::as_far_as_possible();
  if (target.n_faces()) counts = counts.or_faces(*target.n_faces());
  if (target.n_vertices()) counts = counts.or_vertices(*target.n_vertices());
  return counts;
}

std::string_view option_that_ended(StopReason stop) {
  if (stop == StopReason::error) return "--max-error";
  return stop == StopReason::cost ? "--max-cost" : "";
}

std::string to_string(const DecimateTarget& target) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " or ") + part; };
  if (target.n_faces()) add(faces_text(*target.n_faces()));
  if (target.n_vertices()) add(vertices_text(*target.n_vertices()));
  if (target.cost_limit()) add("cost " + shortest(*target.cost_limit()));
  if (target.error_limit()) add("error " + shortest(*target.error_limit()));
  return text;
}

}  // namespace whittle
