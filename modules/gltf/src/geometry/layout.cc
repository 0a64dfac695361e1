#include "geometry/layout.hh"

#include <algorithm>

#include "whittle/core/attribute_kinds.hh"

namespace whittle::gltf {
namespace {

/// "NORMAL" of "target 0 NORMAL"; empty unless of a morph target.
std::string_view name_in_target(std::string_view channel) {
  constexpr std::string_view beginning = "target ";
  if (!channel.starts_with(beginning)) return {};
  channel.remove_prefix(beginning.size());
  const std::size_t space = channel.find(' ');
  return space == std::string_view::npos ? std::string_view{} : channel.substr(space + 1);
}

AttributeKind kind_of(std::string_view channel, const Accessor& accessor) {
  if (const std::string_view name = name_in_target(channel); !name.empty()) {
    if (accessor.shape != ElementShape{3, 1}) return AttributeKind::scalar;
    if (name == "POSITION") return AttributeKind::displacement;
    return name == "NORMAL" || name == "TANGENT" ? AttributeKind::direction : AttributeKind::scalar;
  }
  if (channel.starts_with("TEXCOORD_") && accessor.shape == ElementShape{2, 1}) return AttributeKind::texcoord;
  if (channel == "TANGENT" && accessor.shape == ElementShape{4, 1}) return AttributeKind::tangent;
  if (channel.starts_with("COLOR_")) return AttributeKind::color;
  return kind_of_numbers(channel, accessor.type, accessor.is_normalized);
}

/// The n of "JOINTS_n" or "WEIGHTS_n" if it is below `n_sets`; otherwise `n_sets`.
std::size_t set_of(std::string_view channel, std::string_view beginning, std::size_t n_sets) {
  for (std::size_t n = 0; n < n_sets; ++n) {
    if (channel == std::string(beginning) + std::to_string(n)) return n;
  }
  return n_sets;
}

Attribute attribute_for(const Model& model, const Channel& channel, const Place& place, std::size_t n_sets) {
  const Accessor& accessor = model.accessors[channel.accessor];
  Attribute attribute;
  attribute.name = place.attribute;
  attribute.type = accessor.type;
  attribute.is_normalized = accessor.is_normalized;
  if (place.attribute == joints_and_weights) {
    attribute.kind = AttributeKind::joint_weights;
    attribute.n_components = 2 * joints_a_set * n_sets;
  } else {
    attribute.kind = kind_of(channel.name, accessor);
    attribute.n_components = place.n;
  }
  return attribute;
}

}  // namespace

std::size_t n_joint_sets(const Primitive& primitive) {
  std::size_t n = 0;
  while (primitive.attribute("JOINTS_" + std::to_string(n)) && primitive.attribute("WEIGHTS_" + std::to_string(n))) ++n;
  return n;
}

std::size_t n_joint_sets(const Mesh& mesh) {
  std::size_t most = 0;
  for (const Primitive& primitive : mesh.primitives) {
    if (primitive.is_surface()) most = std::max(most, n_joint_sets(primitive));
  }
  return most;
}

bool has_own_array(std::string_view channel) {
  return channel == "POSITION" || channel == "NORMAL" || channel == "COLOR_0";
}

Place place_of(const Model& model, const Channel& channel, const Primitive& primitive, std::size_t n_sets) {
  const std::size_t n_own_sets = n_joint_sets(primitive);
  const std::string name(joints_and_weights);
  if (const std::size_t n = set_of(channel.name, "JOINTS_", n_own_sets); n < n_own_sets) {
    return {name, joints_a_set * n, joints_a_set};
  }
  if (const std::size_t n = set_of(channel.name, "WEIGHTS_", n_own_sets); n < n_own_sets) {
    return {name, joints_a_set * (n_sets + n), joints_a_set};
  }
  return {channel.name, 0, model.accessors[channel.accessor].shape.n_components()};
}

std::vector<Attribute> attributes_of(const Model& model, const Mesh& mesh) {
  std::vector<Attribute> attributes;
  const std::size_t n_sets = n_joint_sets(mesh);
  for (const Primitive& primitive : mesh.primitives) {
    if (!primitive.is_surface()) continue;
    for (const Channel& channel : channels_of(primitive)) {
      if (has_own_array(channel.name)) continue;
      const Place place = place_of(model, channel, primitive, n_sets);
      const auto found = std::find_if(attributes.begin(), attributes.end(),
                                      [&](const Attribute& a) { return a.name == place.attribute; });
      if (found == attributes.end()) {
        attributes.push_back(attribute_for(model, channel, place, n_sets));
      } else {
        found->n_components = std::max(found->n_components, place.first + place.n);
      }
    }
  }
  return attributes;
}

}  // namespace whittle::gltf
