#include "commands/page/page_tables.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "terminal/table.hh"
#include "whittle/pipeline/values.hh"

namespace whittle::app {
namespace {

using Numbers = std::vector<std::optional<double>>;
enum class Better { smaller, larger };

constexpr const char* length_unit = "model units";

std::string figure_text(double x) {
  constexpr double most = 1e15;
  return x >= 0 && x < most && x == std::floor(x) ? grouped(static_cast<std::uint64_t>(x)) : significant(x);
}

/// The column with the best number, if it is better than all others.
std::optional<std::size_t> best_of(const Numbers& numbers, Better better) {
  std::optional<std::size_t> best;
  std::size_t n_equal = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i]) continue;
    ++n;
    if (best && *numbers[i] == *numbers[*best]) ++n_equal;
    if (best && (better == Better::smaller ? *numbers[i] >= *numbers[*best] : *numbers[i] <= *numbers[*best])) continue;
    best = i;
    n_equal = 1;
  }
  return n > 1 && n_equal == 1 ? best : std::nullopt;
}

/// Adds rows about each mesh.
class MeshRows {
 public:
  MeshRows(const std::vector<MeasuredMesh>& meshes, report::PageTable& table) : meshes_(meshes), table_(table) {}

  /// \param number of a mesh \param better empty: neither is
  template <typename Number>
  void add(const std::string& name, const std::string& unit, std::optional<Better> better, const Number& number) {
    Numbers numbers;
    for (const MeasuredMesh& mesh : meshes_) numbers.push_back(number(mesh));
    report::PageRow row{name, unit, {}, better ? best_of(numbers, *better) : std::nullopt};
    for (const std::optional<double>& x : numbers) row.values.push_back(x ? figure_text(*x) : "");
    const auto has_number = [](const std::optional<double>& x) { return x.has_value(); };
    if (std::any_of(numbers.begin(), numbers.end(), has_number)) table_.rows.push_back(std::move(row));
  }

  /// The same, if one of the meshes has any.
  template <typename Number>
  void add_if_any(const std::string& name, const std::string& unit, const Number& number) {
    const auto has_any = [&](const MeasuredMesh& mesh) { return number(mesh) > 0; };
    if (std::any_of(meshes_.begin(), meshes_.end(), has_any)) add(name, unit, Better::smaller, number);
  }

  /// Of the results.
  template <typename Number>
  void add_distance(const std::string& name, const std::string& unit, const Number& number) {
    add(name, unit, Better::smaller, [&number](const MeasuredMesh& mesh) {
      return mesh.distance ? std::optional<double>(number(*mesh.distance)) : std::nullopt;
    });
  }

 private:
  const std::vector<MeasuredMesh>& meshes_;
  report::PageTable& table_;
};

void add_counts(MeshRows& rows, double n_faces_before) {
  rows.add("Faces", "", {}, [](const MeasuredMesh& mesh) { return static_cast<double>(mesh.topology.faces); });
  rows.add("Faces", "% of the original", {}, [n_faces_before](const MeasuredMesh& mesh) -> std::optional<double> {
    if (!mesh.distance || n_faces_before == 0) return std::nullopt;
    return 100 * static_cast<double>(mesh.topology.faces) / n_faces_before;
  });
  rows.add("Vertices", "", {}, [](const MeasuredMesh& mesh) { return static_cast<double>(mesh.topology.vertices); });
}

void add_distances(MeshRows& rows) {
  using Distance = metrics::SurfaceDistance;
  const std::string share = "% of the diagonal";
  const auto of_diagonal = [](double length, const Distance& distance) {
    return distance.diagonal > 0 ? 100 * length / distance.diagonal : 0;
  };
  rows.add_distance("Mean error", length_unit, [](const Distance& d) { return d.mean; });
  rows.add_distance("Mean error", share, [&](const Distance& d) { return of_diagonal(d.mean, d); });
  rows.add_distance("Largest error, sampled", length_unit, [](const Distance& d) { return d.max; });
  rows.add_distance("Largest error, sampled", share, [&](const Distance& d) { return of_diagonal(d.max, d); });
  rows.add_distance("Mean deviation of normals", "degrees", [](const Distance& d) { return d.normal_deviation_deg; });
  rows.add_distance("Surface turned over", "%", [](const Distance& d) { return d.flipped_percent; });
}

void add_shape_rows(MeshRows& rows) {
  using Mesh = MeasuredMesh;
  rows.add("Mean edge length", length_unit, {}, [](const Mesh& mesh) { return mesh.shape.edge_length_mean; });
  rows.add("Mean triangle shape", "2r/R, 1 is equilateral", Better::larger,
           [](const Mesh& mesh) { return mesh.shape.radius_ratio_mean; });
  rows.add("Mean of the smallest angles", "degrees", Better::larger,
           [](const Mesh& mesh) { return mesh.shape.min_angle_mean_deg; });
  rows.add("Vertices with 5 to 7 edges", "% of those inside", Better::larger,
           [](const Mesh& mesh) { return 100 * mesh.shape.valence.share_5_to_7; });
  rows.add_if_any("Faces without area", "", [](const Mesh& mesh) { return mesh.shape.degenerate_faces; });
  rows.add_if_any("Folded edges", "", [](const Mesh& mesh) { return mesh.shape.folds; });
}

void add_topology_rows(MeshRows& rows) {
  using Mesh = MeasuredMesh;
  rows.add("Parts", "", {}, [](const Mesh& mesh) { return static_cast<double>(mesh.topology.components); });
  rows.add("Borders", "closed curves", {},
           [](const Mesh& mesh) { return static_cast<double>(mesh.topology.boundary_loops); });
  rows.add("Handles (genus)", "", {}, [](const Mesh& mesh) -> std::optional<double> {
    if (!mesh.topology.genus) return std::nullopt;
    return static_cast<double>(*mesh.topology.genus);
  });
  rows.add_if_any("Non-manifold edges", "", [](const Mesh& mesh) { return mesh.topology.nonmanifold_edges; });
  rows.add_if_any("Non-manifold vertices", "", [](const Mesh& mesh) { return mesh.topology.nonmanifold_vertices; });
}

/// Something in a report, or null.
Json value_at(const Json& report, const char* pointer) {
  const Json::json_pointer place(pointer);
  return report.contains(place) ? report.at(place) : Json(nullptr);
}

/// "12,000", "yes", "normal"; empty for null and for what has parts.
std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return yes_no(value.get<bool>());
  if (value.is_number_unsigned()) return grouped(value.get<std::uint64_t>());
  if (value.is_number()) return figure_text(value.get<double>());
  return {};
}

/// "10 % of the vertices, 5,000 vertices"
std::string text_of_target(const Json& report) {
  std::vector<std::string> parts;
  const auto add = [&](const char* key, const std::string& before, const std::string& after, double factor) {
    const Json value = value_at(report, key);
    if (!value.is_number()) return;
    const double number = value.get<double>() * factor;
    parts.push_back(before + figure_text(number) + after);
  };
  add("/target/ratio", "", " % of the vertices", 100);
  add("/target/face_ratio", "", " % of the faces", 100);
  add("/target/vertices", "", " vertices", 1);
  add("/target/faces", "", " faces", 1);
  add("/target/max_error", "an error of at most ", "", 1);
  add("/target/max_cost", "contractions of a cost of at most ", "", 1);
  return parts.empty() ? "as few faces as possible" : listed(parts);
}

/// Why it ended, by the word of the report.
std::string text_of_stop(const std::string& word) {
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"target", "the target was met"},
      {"cost", "each further contraction costs more"},
      {"error", "each further contraction takes the surface too far away"},
      {"exhausted", "no further contraction is allowed"},
      {"cancelled", "it was stopped"}};
  for (const auto& [known, text] : texts) {
    if (known == word) return text;
  }
  return word;
}

}  // namespace

report::PageTable mesh_table(const std::vector<MeasuredMesh>& meshes) {
  report::PageTable table{"Meshes", {}, {}};
  for (const MeasuredMesh& mesh : meshes) table.columns.push_back(mesh.name);
  MeshRows rows(meshes, table);
  add_counts(rows, static_cast<double>(meshes.front().topology.faces));
  add_distances(rows);
  add_shape_rows(rows);
  add_topology_rows(rows);
  return table;
}

report::PageTable run_table(const std::string& title, const Json& report) {
  report::PageTable table{title, {}, {}};
  const auto add = [&table](const std::string& name, const std::string& unit, const std::string& value) {
    if (!value.empty()) table.rows.push_back({name, unit, {value}, std::nullopt});
  };
  const auto add_at = [&](const std::string& name, const std::string& unit, const char* key) {
    add(name, unit, text_of(value_at(report, key)));
  };
  add("Asked for", "", text_of_target(report));
  add("Ended because", "", text_of_stop(text_of(value_at(report, "/stop"))));
  add_at("Effort", "", "/options/effort");
  add_at("Cost", "", "/options/cost");
  add_at("Contractions", "", "/contractions");
  add_at("Largest error, proven", "model units, at most", "/max_error/proven");
  add_at("Vertices moved by the fit", "", "/polish/moved");
  add_at("Time to decimate", "s", "/seconds/decimate");
  add_at("Time to fit", "s", "/seconds/polish");
  if (value_at(report, "/seconds/total") != 0) add_at("Time in all", "s", "/seconds/total");
  const Json memory = value_at(report, "/peak_rss_bytes");
  if (memory.is_number_unsigned()) add("Memory at most", "MiB", grouped(memory.get<std::uint64_t>() >> 20U));
  return table;
}

}  // namespace whittle::app
