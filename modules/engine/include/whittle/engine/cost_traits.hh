#pragma once

#include <array>
#include <cstddef>
#include <string_view>

// What is known of each cost before a run: one row a cost. The library's checks and defaults, the program's choices,
// conflicts and report, and the tables in docs/user are made from these rows or tested against them.

namespace whittle {

/// What ranks and places contractions.
enum class Cost {
  quadric,     ///< Garland–Heckbert (quadric_term.hh): distance to all planes merged so far. Unit: distance² · area
               ///< (distance² with uniform weights)
  memoryless,  ///< Quadrics of the faces as they are; keeps the volume (memoryless_term.hh). Unit: length⁵
  lindstrom_turk,  ///< Lindstrom–Turk (lindstrom_turk.hh): change of volume against the faces as they are. Unit:
                   ///< length⁶
  midpoint         ///< Length of the edge; places at its middle. Unit: length
};

/// In which order pairs are contracted.
enum class Order {
  automatic,   ///< The default of the cost (`CostTraits::default_order`).
  exact,       ///< That of an algorithm which evaluates every pair again after each contraction.
  approximate  ///< Faster: a pair that gets cheaper is noticed only when its old turn comes. The result differs a
               ///< little between units whose ratio is no power of two.
};

/// Why an option doesn't go with a cost; empty where it does.
struct CostConflicts {
  std::string_view weights{};                   ///< `QuadricOptions::weights` other than by area
  std::string_view placement{};                 ///< `QuadricOptions::placement` other than optimal
  std::string_view boundary_weight{};           ///< `QuadricOptions::boundary_weight`
  std::string_view regularization{};            ///< `QuadricOptions::regularization`
  std::string_view isotropy{};                  ///< `DecimateOptions::isotropy`
  std::string_view valence_weight{};            ///< `DecimateOptions::valence_weight`
  std::string_view threshold{};                 ///< `PairOptions::threshold`
  std::string_view threshold_in_exact_order{};  ///< the same together with `Order::exact`
};

/// One row of the table of costs.
struct CostTraits {
  Cost cost;
  std::string_view name;  ///< on the command line and in reports
  double dimension;       ///< The power of a length that is the cost's unit, with weights by area.
  Order default_order;    ///< exact or approximate

  bool has_quadrics = false;            ///< Costs are quadrics, which hold planes, seams and attributes.
  bool goes_in_blocks = false;          ///< Large meshes are contracted in blocks that fit a cache.
  bool goes_in_blocks_exactly = false;  ///< Blocks contract what one queue over the whole mesh would contract.

  /// How far faces may turn by default, degrees. Measured: Lindstrom–Turk is more accurate where faces may turn
  /// further, memoryless quadrics where they may turn less.
  double default_max_normal_flip_deg;

  CostConflicts why_not{};
};

/// Why threshold pairs don't go with most costs, nor with `isotropy` or `valence_weight`.
inline constexpr std::string_view plain_quadrics_alone = "vertices that no edge joins go with plain quadrics alone";
/// Why `boundary_weight` doesn't go with `Boundary::free`.
inline constexpr std::string_view free_borders_have_no_weight = "nothing holds borders that are free";

/// The table: a row a cost, in the order of the enumeration.
inline constexpr std::array<CostTraits, 4> all_cost_traits{
    {{.cost = Cost::quadric,
      .name = "quadric",
      .dimension = 4,
      .default_order = Order::exact,
      .has_quadrics = true,
      .goes_in_blocks = true,
      .goes_in_blocks_exactly = true,
      .default_max_normal_flip_deg = 75},

     {.cost = Cost::memoryless,
      .name = "memoryless",
      .dimension = 5,
      .default_order = Order::approximate,
      .has_quadrics = true,
      .goes_in_blocks = true,
      .default_max_normal_flip_deg = 60,
      .why_not = {.weights = "its planes change, and count by area",
                  .isotropy = "it blends quadrics that remember with the length of edges",
                  .threshold_in_exact_order = "vertices that no edge joins have no place in its exact order"}},

     {.cost = Cost::lindstrom_turk,
      .name = "lindstrom-turk",
      .dimension = 6,
      .default_order = Order::exact,
      .default_max_normal_flip_deg = 110,
      .why_not = {.weights = "the cost has no quadrics",
                  .placement = "the cost has a placement of its own",
                  .boundary_weight = "the cost has a term of its own for borders",
                  .regularization = "the cost has no quadrics",
                  .isotropy = "it blends quadrics with the length of edges",
                  .threshold = plain_quadrics_alone}},

     {.cost = Cost::midpoint,
      .name = "midpoint",
      .dimension = 1,
      .default_order = Order::exact,
      .default_max_normal_flip_deg = 75,
      .why_not = {.weights = "the cost has no quadrics",
                  .placement = "the cost has a placement of its own",
                  .boundary_weight = "the cost has no quadrics",
                  .regularization = "the cost has no quadrics",
                  .isotropy = "it blends quadrics with the length of edges",
                  .threshold = plain_quadrics_alone}}}};

constexpr const CostTraits& cost_traits(Cost cost) { return all_cost_traits[static_cast<std::size_t>(cost)]; }

/// "quadric", "memoryless", …
constexpr std::string_view to_string(Cost cost) { return cost_traits(cost).name; }

}  // namespace whittle
