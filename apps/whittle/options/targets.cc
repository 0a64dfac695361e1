#include "options/targets.hh"

#include "terminal/errors.hh"
#include "terminal/table.hh"

namespace whittle::app {

void check_targets(const Targets& targets, const std::string& all) {
  if (!targets.any()) throw UsageError("no target: give at least one of " + all);
}

nlohmann::ordered_json target_json(const Targets& targets, const DecimateTarget& target) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (target.n_faces()) json["faces"] = *target.n_faces();
  if (target.n_vertices()) json["vertices"] = *target.n_vertices();
  if (targets.ratio) json["ratio"] = *targets.ratio;
  if (targets.face_ratio) json["face_ratio"] = *targets.face_ratio;
  if (target.cost_limit()) json["max_cost"] = *target.cost_limit();
  if (target.error_limit()) json["max_error"] = *target.error_limit();
  if (targets.max_border_error && target.border_error_limit()) json["max_error_borders"] = *target.border_error_limit();
  return json;
}

}  // namespace whittle::app
