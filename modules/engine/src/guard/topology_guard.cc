#include "guard/topology_guard.hh"

#include "complex/link_condition.hh"
#include "complex/nonmanifold_contraction.hh"

namespace whittle {

/// Threshold pairs may change the topology. With `Topology::keep` edges may not; at vertices that aren't manifold the
/// link condition is sufficient but not necessary, so what the contraction would do decides.
bool TopologyGuard::refuses(ContractionProfile& profile) {
  const auto& [id, a, b] = profile.pair;
  const bool is_edge = !complex_.is_threshold_pair(id);
  if (is_edge && link_condition(complex_, profile)) return false;
  const bool keeps = is_edge && topology_ == Topology::keep;
  if (keeps && complex_.is_manifold(a) && complex_.is_manifold(b)) return true;
  // A non-manifold contraction changes stars of neighbours, of which frozen ones have only a part here.
  if (complex_.has_frozen_vertices()) return true;
  plan_nonmanifold(complex_, profile);
  const bool takes_last_face = profile.opposites.size() + profile.nonmanifold.coincident.size() == complex_.n_faces();
  if (takes_last_face) return true;
  if (!keeps) return is_edge && stays_closed_ && opens_closed_manifold(complex_, profile);
  // Where threshold pairs join parts, walls between these vanish and gaps close. That changes the Euler number.
  const bool may_change_euler_number = complex_.has_threshold_pairs();
  return !is_no_less_manifold(complex_, profile) || !(may_change_euler_number || keeps_euler_number(profile));
}

}  // namespace whittle
