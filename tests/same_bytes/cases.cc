#include "cases.hh"

#include <utility>

#include "shapes.hh"
#include "whittle/io/read.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

/// What is done with a mesh.
struct Recipe {
  std::string name;
  double share = 0.1;  ///< of the faces
  Effort effort = Effort::fast;
  SimplifyOptions options{};
};

IndexedMesh follow(const Recipe& recipe, const IndexedMesh& mesh) {
  const auto n_faces = static_cast<std::uint64_t>(recipe.share * static_cast<double>(mesh.faces.size()));
  return simplify(mesh, DecimateTarget::faces(n_faces), recipe.effort, recipe.options).mesh;
}

template <class Change>
Recipe recipe(std::string name, Effort effort, const Change& change) {
  Recipe result{std::move(name), 0.1, effort, {}};
  change(result.options.decimate);
  return result;
}

Recipe by_cost(std::string name, Cost cost, Order order = Order::automatic) {
  return recipe(std::move(name), Effort::fast, [&](DecimateOptions& options) {
    options.cost = cost;
    options.order = order;
  });
}

/// Each option that brings other arithmetic.
std::vector<Recipe> recipes_of_options() {
  const auto change = [](std::string name, const auto& set) { return recipe(std::move(name), Effort::fast, set); };
  using Options = DecimateOptions;
  return {
      by_cost("midpoint", Cost::midpoint),
      change("isotropic", [](Options& options) { options.isotropy = 0.3; }),
      change("valence", [](Options& options) { options.valence_weight = 1; }),
      change("uniform", [](Options& options) { options.quadric.weights = Weights::uniform; }),
      change("area-angle", [](Options& options) { options.quadric.weights = Weights::area_angle; }),
      change("endpoint", [](Options& options) { options.quadric.placement = Placement::endpoint; }),
      change("radius-ratio", [](Options& options) { options.min_radius_ratio = 0.1; }),
      change("features", [](Options& options) { options.feature_angle_deg = 35; }),
      change("threshold",
             [](Options& options) {
               options.pairs.threshold = 0.02;
               options.topology = Topology::free;
             }),
      change("intersections", [](Options& options) { options.refuse_intersections = true; }),
      change("locked-border", [](Options& options) { options.boundary = Boundary::locked; }),
  };
}

/// Those of them that go in rounds where a mesh is large.
std::vector<Recipe> recipes_of_rounds() {
  std::vector<Recipe> recipes = recipes_of_options();
  std::erase_if(recipes, [](const Recipe& recipe) {
    return recipe.name != "valence" && recipe.name != "endpoint" && recipe.name != "radius-ratio" &&
           recipe.name != "locked-border";
  });
  return recipes;
}

class List {
 public:
  template <class Mesh>
  void add(const std::string& mesh_name, const Mesh& mesh, const std::vector<Recipe>& recipes) {
    for (const Recipe& recipe : recipes) {
      all.push_back({mesh_name + '/' + recipe.name, [mesh, recipe] { return follow(recipe, mesh()); }});
    }
  }

  std::vector<Case> all;
};

}  // namespace

std::vector<Case> cases(const std::filesystem::path& data) {
  const auto file = [&](const char* name) { return [path = data / name] { return io::read_mesh(path).mesh; }; };
  const Recipe fast{"fast", 0.1, Effort::fast, {}};
  const Recipe normal{"normal", 0.1, Effort::normal, {}};
  const Recipe best{"best", 0.05, Effort::best, {}};
  const Recipe max{"max", 0.05, Effort::normal, {.fit = Fit::max}};
  const Recipe lindstrom_turk = by_cost("lindstrom-turk", Cost::lindstrom_turk, Order::exact);
  const Recipe memoryless_exact = by_cost("memoryless-exact", Cost::memoryless, Order::exact);
  List list;
  list.add("knot.ply", file("knot.ply"), {fast, normal, best});
  list.add("terrain.ply", file("terrain.ply"), {fast, normal, best, lindstrom_turk});
  list.add("blob.obj", file("blob.obj"), {normal, lindstrom_turk, memoryless_exact, max});
  list.add("bracket.stl", file("bracket.stl"), {fast, normal});
  list.add("cylinder.off", file("cylinder.off"), {fast, best});
  list.add("nonmanifold.obj", file("nonmanifold.obj"), {fast, normal});
  list.add("cubes.obj", file("cubes.obj"), {fast});
  list.add("hills", [] { return hills(96); }, {fast, normal, best});
  list.add(
      "hills", [] { return hills(24); }, recipes_of_options());
  list.add("rough_cube", [] { return rough_cube(48); }, {fast, best});
  list.add("painted_hills", [] { return painted(hills(24)); }, {fast, normal, lindstrom_turk});
  // Large enough for blocks and rounds, with a border and closed, and with attributes.
  list.add("large_hills", [] { return hills(272); }, {fast, normal});
  list.add("large_rough_cube", [] { return rough_cube(112); }, {fast, best});
  list.add(
      "large_hills", [] { return hills(272); }, recipes_of_rounds());
  list.add("large_painted_hills", [] { return painted(hills(272)); }, {fast, normal});
  list.add(
      "two_cubes", [] { return two_cubes(12); }, recipes_of_options());
  list.add("crossed_sheets", [] { return crossed_sheets(24); }, {fast, normal, lindstrom_turk});
  return std::move(list.all);
}

}  // namespace whittle::test
