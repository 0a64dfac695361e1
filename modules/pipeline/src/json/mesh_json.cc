#include "whittle/pipeline/json.hh"

#include <utility>

// What is reported of meshes.

namespace whittle {
namespace {

Json over_diagonal(double value, double diagonal) { return diagonal > 0 ? Json(value / diagonal) : Json(nullptr); }

Json directed(const metrics::DirectedDistance& distance, double diagonal) {
  Json json;
  add_length(json, "mean", distance.mean, diagonal);
  add_length(json, "rms", distance.rms, diagonal);
  add_length(json, "max", distance.max, diagonal);
  json["normal_deviation_deg"] = distance.normal_deviation_deg;
  json["flipped_percent"] = distance.flipped_percent;
  return json;
}

Json directed(const metrics::DirectedLineDistance& distance, double diagonal) {
  Json json;
  add_length(json, "mean", distance.mean, diagonal);
  add_length(json, "max", distance.max, diagonal);
  return json;
}

}  // namespace

void add_length(Json& json, const std::string& key, double length, double diagonal) {
  json[key] = length;
  json[key + "_rel"] = over_diagonal(length, diagonal);
}

Json largest_json(const metrics::LargestDistance& largest, double diagonal) {
  Json json;
  add_length(json, "at_least", largest.at_least, diagonal);
  add_length(json, "at_most", largest.at_most, diagonal);
  const Vec3& point = largest.where.point;
  json["point"] = {point.x(), point.y(), point.z()};
  json["face"] = largest.where.face;
  json["far_faces"] = largest.n_far_faces;
  return json;
}

Json repairs_json(const io::Repairs& repairs) {
  Json json = Json::object();
  for (const auto& [name, count] : repairs.entries()) json[std::string(name)] = count;
  return json;
}

void add_topology(Json& json, const metrics::Topology& topology) {
  json["manifold"] = topology.manifold;
  json["closed"] = topology.closed;
  json["components"] = topology.components;
  json["boundary_loops"] = topology.boundary_loops;
  json["genus"] = topology.genus ? Json(*topology.genus) : Json(nullptr);
  json["nonmanifold_edges"] = topology.nonmanifold_edges;
  json["nonmanifold_vertices"] = topology.nonmanifold_vertices;
}

void add_distance(Json& json, const metrics::SurfaceDistance& distance) {
  const double diagonal = distance.diagonal;
  add_length(json, "mean", distance.mean, diagonal);
  add_length(json, "rms", distance.rms, diagonal);
  add_length(json, "max", distance.max, diagonal);
  json["garland_heckbert"] = distance.garland_heckbert;
  json["garland_heckbert_rel"] = over_diagonal(distance.garland_heckbert, diagonal * diagonal);
  json["forward"] = directed(distance.forward, diagonal);
  json["backward"] = directed(distance.backward, diagonal);
  json["normal_deviation_deg"] = distance.normal_deviation_deg;
  json["flipped_percent"] = distance.flipped_percent;
}

Json lines_json(const std::optional<metrics::LineDistance>& distance, double diagonal) {
  if (!distance) return nullptr;
  Json json;
  add_length(json, "mean", distance->mean, diagonal);
  add_length(json, "max", distance->max, diagonal);
  json["forward"] = directed(distance->forward, diagonal);
  json["backward"] = directed(distance->backward, diagonal);
  return json;
}

void add_shape(Json& json, const metrics::Shape& shape) {
  json["radius_ratio"] = {{"mean", shape.radius_ratio_mean}, {"min", shape.radius_ratio_min}};
  json["min_angle_deg"] = {{"mean", shape.min_angle_mean_deg}, {"min", shape.min_angle_min_deg}};
  Json histogram = Json::object();
  for (const auto& [valence, count] : shape.valence.histogram) histogram[std::to_string(valence)] = count;
  json["valence"] = {{"min", shape.valence.min},
                     {"max", shape.valence.max},
                     {"share_5_to_7", shape.valence.share_5_to_7},
                     {"histogram", std::move(histogram)}};
  json["edge_length_cv"] = shape.edge_length_cv;
  json["folds"] = shape.folds;
  json["degenerate_faces"] = shape.degenerate_faces;
}

Json polish_json(const PolishResult& polish) {
  return {{"passes", polish.n_passes},
          {"moved", polish.n_moved},
          {"rms_before", polish.rms_before},
          {"rms_after", polish.rms_after}};
}

Json input_json(const Scene& input, double diagonal) {
  Json json = {
      {"path", input.path},   {"vertices", input.read.mesh.positions.size()}, {"faces", input.read.mesh.faces.size()},
      {"diagonal", diagonal}, {"repairs", repairs_json(input.read.repairs)},  {"weld_tolerance", input.weld_tolerance}};
  if (!input.joined.empty()) json["joined"] = input.joined;
  return json;
}

}  // namespace whittle
