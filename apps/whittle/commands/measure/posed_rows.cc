#include "commands/measure/posed_rows.hh"

#include "terminal/table.hh"

namespace whittle::app {
namespace {

Json mean_json(const MeanDistance& distance, double diagonal) {
  Json json;
  add_length(json, "mean", distance.both, diagonal);
  add_length(json["forward"], "mean", distance.forward, diagonal);
  add_length(json["backward"], "mean", distance.backward, diagonal);
  return json;
}

/// A quotient of two lengths; empty if there is none.
std::string quotient_text(double length, double over) { return over == 0 ? "" : significant(length / over); }

/// "worst pose: 7 of 16, walk at 1.25 s"
std::string worst_line(const PosedDistance& posed) {
  std::string line = "worst pose: " + std::to_string(posed.worst_pose + 1) + " of " + std::to_string(posed.n_poses);
  if (const auto& moment = posed.worst_moment) {
    line += ", " + posed.worst_animation + " at " + significant(moment->seconds) + " s";
  }
  return line + '\n';
}

}  // namespace

Json posed_json(const PosedDistance& posed) {
  Json json;
  json["poses"] = posed.n_poses;
  json["animated"] = posed.worst_moment.has_value();
  json["diagonal"] = posed.diagonal;
  json["rest"] = mean_json(posed.rest, posed.diagonal);
  json["average"] = mean_json(posed.average, posed.diagonal);
  Json& worst = json["worst"] = mean_json(posed.worst, posed.diagonal);
  worst["pose"] = posed.worst_pose + 1;
  worst["animation"] = posed.worst_moment ? Json(posed.worst_animation) : Json(nullptr);
  worst["seconds"] = posed.worst_moment ? Json(posed.worst_moment->seconds) : Json(nullptr);
  json["ratio"] = posed.ratio() ? Json(*posed.ratio()) : Json(nullptr);
  return json;
}

std::string posed_table(const PosedDistance& posed) {
  Table table;
  const auto add = [&](const std::string& name, const MeanDistance& distance) {
    const auto length = [&](double x) { return length_text(x, posed.diagonal); };
    table.add({name, length(distance.both), length(distance.forward), length(distance.backward)});
  };
  table.add({"scene, mean distance", "both ways", "from REF to TEST", "from TEST to REF"});
  add("at rest", posed.rest);
  add("mean of " + counted(posed.n_poses, "pose", "poses"), posed.average);
  add("worst pose", posed.worst);
  if (posed.ratio()) {
    table.add({"poses / rest", quotient_text(posed.average.both, posed.rest.both),
               quotient_text(posed.average.forward, posed.rest.forward),
               quotient_text(posed.average.backward, posed.rest.backward)});
  }
  return table.text() + "in brackets: over the diagonal of REF's scene at rest, which is " +
         significant(posed.diagonal) + '\n' + worst_line(posed);
}

}  // namespace whittle::app
