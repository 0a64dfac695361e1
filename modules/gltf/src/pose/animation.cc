#include "pose/animation.hh"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace whittle::gltf {
namespace {

constexpr std::array<std::pair<const char*, Path>, 4> paths{{{"translation", Path::translation},
                                                             {"rotation", Path::rotation},
                                                             {"scale", Path::scale},
                                                             {"weights", Path::weights}}};

std::optional<Path> path_of(const Part& target) {
  const std::string word = target.required_text("path");
  const auto found = std::find_if(paths.begin(), paths.end(), [&](const auto& row) { return row.first == word; });
  if (found == paths.end()) return {};
  return found->second;
}

Keyed keyed_by(Path path, std::size_t n_targets) {
  switch (path) {
    case Path::rotation:
      return {.shape = {4, 1}, .is_rotation = true};
    case Path::weights:
      return {.shape = {1, 1}, .n_elements = n_targets};
    default:
      return {.shape = {3, 1}};
  }
}

/// None if it isn't about a node, or about nothing that a pose has.
std::optional<Track> read_track(const Model& model, const Part& channel, const std::vector<Part>& samplers,
                                std::span<const std::size_t> n_targets) {
  const std::size_t sampler = channel.required_index("sampler", samplers.size(), "sampler");
  const std::optional<Part> target = channel.object("target");
  if (!target) channel.fail("\"target\" is missing");
  const std::optional<Path> path = path_of(*target);
  const std::optional<std::size_t> number = target->index("node", model.nodes.size(), "node");
  if (!path || !number) return {};
  const Node& node = model.nodes[*number];
  if (*path != Path::weights && !node.transform) {
    channel.fail("node " + std::to_string(*number) + " has a matrix, which can't be animated");
  }
  const std::size_t n = node.mesh ? n_targets[*node.mesh] : 0;
  if (*path == Path::weights && n == 0) return {};
  return Track{*number, *path, Sampler(model, samplers[sampler], keyed_by(*path, n))};
}

Animation read_animation(const Model& model, const Part& part, std::span<const std::size_t> n_targets) {
  Animation animation;
  animation.name = printable(part.text("name").value_or(""));
  const std::vector<Part> samplers = part.array("samplers", "sampler");
  for (const Part& channel : part.array("channels", "channel")) {
    std::optional<Track> track = read_track(model, channel, samplers, n_targets);
    if (!track) continue;
    const bool is_first = animation.tracks.empty();
    const double begin = track->sampler.first_time();
    const double end = track->sampler.last_time();
    animation.begin = is_first ? begin : std::min(animation.begin, begin);
    animation.end = is_first ? end : std::max(animation.end, end);
    animation.tracks.push_back(*std::move(track));
  }
  return animation;
}

template <std::size_t n>
void assign(std::array<double, n>& vector, const std::vector<double>& numbers) {
  std::copy_n(numbers.begin(), n, vector.begin());
}

}  // namespace

std::vector<Animation> read_animations(const Model& model, const Part& root, std::span<const std::size_t> n_targets) {
  std::vector<Animation> animations;
  for (const Part& part : root.array("animations", "animation")) {
    animations.push_back(read_animation(model, part, n_targets));
    std::string& name = animations.back().name;
    if (name.empty()) name = "animation " + std::to_string(animations.size() - 1);
  }
  return animations;
}

void animate(const Model& model, const Animation& animation, double seconds, Pose& pose) {
  std::map<std::size_t, Transform> moved;
  for (const Track& track : animation.tracks) {
    std::vector<double> value = track.sampler.at(seconds);
    if (track.path == Path::weights) {
      pose.weights[track.node] = std::move(value);
      continue;
    }
    Transform& transform = moved.try_emplace(track.node, *model.nodes[track.node].transform).first->second;
    if (track.path == Path::translation) assign(transform.translation, value);
    if (track.path == Path::rotation) assign(transform.rotation, value);
    if (track.path == Path::scale) assign(transform.scale, value);
  }
  for (const auto& [node, transform] : moved) pose.nodes[node] = transform.matrix();
}

std::vector<AnimationTime> moments(std::span<const Animation> animations, std::size_t n) {
  std::vector<double> lengths;
  double total = 0;
  for (const Animation& animation : animations) total += lengths.emplace_back(animation.end - animation.begin);
  if (total == 0) {
    for (std::size_t a = 0; a < animations.size(); ++a) lengths[a] = animations[a].tracks.empty() ? 0 : 1;
    total = static_cast<double>(std::count(lengths.begin(), lengths.end(), 1.0));
  }
  std::vector<AnimationTime> moments;
  if (animations.empty()) return moments;
  std::size_t at = 0;
  double before = 0;  // length of all animations before that
  for (std::size_t k = 0; k < n; ++k) {
    const double time = total * ((static_cast<double>(k) + 0.5) / static_cast<double>(n));
    while (at + 1 < lengths.size() && before + lengths[at] <= time) before += lengths[at++];
    // Rounding may pass the end of the last one.
    const double seconds = std::min(animations[at].begin + (time - before), animations[at].end);
    moments.push_back({at, seconds});
  }
  return moments;
}

}  // namespace whittle::gltf
