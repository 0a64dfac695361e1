#include "commands/measure/posed.hh"

#include <utility>
#include <vector>

#include "terminal/errors.hh"
#include "terminal/table.hh"
#include "whittle/scene/gltf_asset.hh"

namespace whittle::app {
namespace {

void refuse_stiff(const gltf::Poser& poser, const std::string& name) {
  if (poser.has_skins() || poser.has_morph_targets()) return;
  throw UnsupportedMesh(name + ": it has neither a skin nor a morph target, so there is nothing for --posed to pose");
}

void refuse_different(const std::string& name, const char* what, std::size_t in_reference, std::size_t in_test) {
  if (in_reference == in_test) return;
  throw UnsupportedMesh(name + ": --posed needs the " + what + " of REF, which has " + std::to_string(in_reference) +
                        "; here are " + std::to_string(in_test));
}

MeanDistance mean_of(const metrics::SurfaceDistance& distance) {
  return {distance.mean, distance.forward.mean, distance.backward.mean};
}

void add_share(MeanDistance& sum, const MeanDistance& distance, std::size_t n) {
  sum.both += distance.both / static_cast<double>(n);
  sum.forward += distance.forward / static_cast<double>(n);
  sum.backward += distance.backward / static_cast<double>(n);
}

}  // namespace

std::optional<double> PosedDistance::ratio() const {
  if (rest.both == 0) return {};
  return average.both / rest.both;
}

PosedScenes::PosedScenes(const Scene& reference, const Scene& test)
    : reference_(gltf_asset_of(reference)), test_(gltf_asset_of(test)) {
  refuse_stiff(reference_, reference.name);
  refuse_stiff(test_, test.name);
  refuse_different(test.name, "nodes", reference_.n_nodes(), test_.n_nodes());
  refuse_different(test.name, "animations", reference_.n_animations(), test_.n_animations());
}

metrics::SurfaceDistance PosedScenes::distance(const std::optional<gltf::AnimationTime>& moment, std::size_t number,
                                               const metrics::DistanceOptions& options) const {
  const auto posed = [&](const gltf::Poser& poser) {
    return poser.mesh(moment ? poser.animated(*moment) : poser.artificial(number));
  };
  return metrics::surface_distance(posed(reference_), posed(test_), options);
}

PosedDistance PosedScenes::measure(std::size_t n_poses, metrics::DistanceOptions options, ProgressBar& bar) const {
  const auto set_progress = [&](std::size_t step) {
    const double length = 1 / static_cast<double>(n_poses + 1);
    options.progress = part_of(bar, static_cast<double>(step) * length, static_cast<double>(step + 1) * length);
  };
  std::vector<std::optional<gltf::AnimationTime>> moments(n_poses);
  if (reference_.is_animated()) {
    const std::vector<gltf::AnimationTime> animated = reference_.moments(n_poses);
    moments.assign(animated.begin(), animated.end());
  }
  PosedDistance posed;
  posed.n_poses = n_poses;
  set_progress(0);
  const metrics::SurfaceDistance rest =
      metrics::surface_distance(reference_.mesh(reference_.rest()), test_.mesh(test_.rest()), options);
  posed.rest = mean_of(rest);
  posed.diagonal = rest.diagonal;
  for (std::size_t k = 0; k < n_poses; ++k) {
    set_progress(k + 1);
    const MeanDistance mean = mean_of(distance(moments[k], k, options));
    add_share(posed.average, mean, n_poses);
    if (k > 0 && mean.both <= posed.worst.both) continue;
    posed.worst = mean;
    posed.worst_pose = k;
  }
  posed.worst_moment = moments[posed.worst_pose];
  if (posed.worst_moment) posed.worst_animation = reference_.animation_name(posed.worst_moment->animation);
  return posed;
}

}  // namespace whittle::app
