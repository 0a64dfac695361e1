#include "write/references.hh"

#include <algorithm>

#include "model/extensions.hh"
#include "model/scalars.hh"

namespace whittle::gltf {
namespace {

using Found = std::function<void(const Json&)>;

void find_in_members(const Json* object, const Found& found) {
  if (!object || !object->is_object()) return;
  for (const auto& [name, value] : object->items()) found(value);
}

void find_member(const Json& object, std::string_view name, const Found& found) {
  if (const Json* value = member(object, name)) found(*value);
}

const Json* extension_of(const Json& object, std::string_view name) {
  const Json* const extensions = member(object, "extensions");
  return extensions ? member(*extensions, name) : nullptr;
}

/// Calls `function` with the name and the value of each extension, wherever it is. Extras are no place for one.
void for_each_extension(const Json& value, const std::function<void(const std::string&, const Json&)>& function) {
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) {
      if (name == "extensions" && inner.is_object()) {
        for (const auto& [extension, content] : inner.items()) function(extension, content);
      }
      if (name != "extras") for_each_extension(inner, function);
    }
  } else if (value.is_array()) {
    for (const Json& inner : value) for_each_extension(inner, function);
  }
}

void find_all_numbers(const Json& value, const Found& found) {
  if (value.is_structured()) {
    for (const Json& inner : value) find_all_numbers(inner, found);
  } else if (value.is_number()) {
    found(value);
  }
}

void find_in_unknown_extensions(const Json& document, const Found& found) {
  for_each_extension(document, [&](const std::string& name, const Json& content) {
    if (!is_known_extension(name)) find_all_numbers(content, found);
  });
}

void find_accessors_of_primitive(const Json& primitive, const Found& found) {
  find_in_members(member(primitive, "attributes"), found);
  for (const Json& target : elements_of(primitive, "targets")) find_in_members(&target, found);
  find_member(primitive, "indices", found);
  if (const Json* outline = extension_of(primitive, outline_extension)) find_member(*outline, "indices", found);
}

void find_accessors(const Json& document, const Found& found) {
  for (const Json& mesh : elements_of(document, "meshes")) {
    for (const Json& primitive : elements_of(mesh, "primitives")) find_accessors_of_primitive(primitive, found);
    const Json* const manifold = extension_of(mesh, manifold_extension);
    if (manifold) find_all_numbers(*manifold, found);
  }
  for (const Json& animation : elements_of(document, "animations")) {
    for (const Json& sampler : elements_of(animation, "samplers")) {
      find_member(sampler, "input", found);
      find_member(sampler, "output", found);
    }
  }
  for (const Json& skin : elements_of(document, "skins")) find_member(skin, "inverseBindMatrices", found);
  for (const Json& node : elements_of(document, "nodes")) {
    const Json* const instancing = extension_of(node, instancing_extension);
    if (instancing) find_in_members(member(*instancing, "attributes"), found);
  }
  find_in_unknown_extensions(document, found);
}

void find_views_of_accessor(const Json& accessor, const Found& found) {
  find_member(accessor, "bufferView", found);
  const Json* const sparse = member(accessor, "sparse");
  if (!sparse) return;
  for (const char* const part : {"indices", "values"}) {
    if (const Json* values = member(*sparse, part)) find_member(*values, "bufferView", found);
  }
}

void find_views_of_metadata(const Json& document, const Found& found) {
  const Json* const metadata = extension_of(document, structural_metadata_extension);
  if (!metadata) return;
  for (const Json& table : elements_of(*metadata, "propertyTables")) {
    find_in_members(member(table, "properties"), [&](const Json& property) {
      for (const char* const name : {"values", "arrayOffsets", "stringOffsets"}) find_member(property, name, found);
    });
  }
}

void find_views(const Json& document, const std::vector<bool>& accessors, const Found& found) {
  const Json& all = elements_of(document, "accessors");
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (accessors[i]) find_views_of_accessor(all[i], found);
  }
  for (const Json& image : elements_of(document, "images")) find_member(image, "bufferView", found);
  for (const Json& mesh : elements_of(document, "meshes")) {
    for (const Json& primitive : elements_of(mesh, "primitives")) {
      if (const Json* draco = extension_of(primitive, draco_extension)) find_member(*draco, "bufferView", found);
    }
  }
  find_views_of_metadata(document, found);
  find_in_unknown_extensions(document, found);
}

Found marking(std::vector<bool>& used) {
  return [&used](const Json& value) {
    const std::optional<std::size_t> number = as_whole(value);
    if (number && *number < used.size()) used[*number] = true;
  };
}

bool is_range(const Json& value) {
  const Json* const buffer = member(value, "buffer");
  const Json* const length = member(value, "byteLength");
  return buffer && length && as_whole(*buffer) && as_whole(*length);
}

void find_ranges_in_extensions(Json& value, bool is_extension, const std::function<void(Json&)>& function) {
  if (is_extension && is_range(value)) function(value);
  if (value.is_object()) {
    for (auto& [name, inner] : value.items()) {
      if (name != "extras") find_ranges_in_extensions(inner, is_extension || name == "extensions", function);
    }
  } else if (value.is_array()) {
    for (Json& inner : value) find_ranges_in_extensions(inner, is_extension, function);
  }
}

/// Without KHR_mesh_quantization. \param is_target whether it is one of a morph target
bool is_plain_type(std::string_view name, const Json& accessor, bool is_target) {
  const Json* const type = member(accessor, "componentType");
  const std::size_t number = type ? as_whole(*type).value_or(0) : 0;
  const bool is_float = number == component_type(ScalarType::float32);
  if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") return is_float;
  if (!name.starts_with("TEXCOORD_") || is_target || is_float) return true;
  const Json* const normalized = member(accessor, "normalized");
  return normalized && normalized->is_boolean() && normalized->get<bool>() &&
         (number == component_type(ScalarType::uint8) || number == component_type(ScalarType::uint16));
}

}  // namespace

bool has_thickness(const Json& material) {
  const Json* const extensions = member(material, "extensions");
  return extensions && member(*extensions, "KHR_materials_volume");
}

const Json& elements_of(const Json& object, std::string_view name) {
  static const Json none = Json::array();
  const Json* const found = member(object, name);
  return found && found->is_array() ? *found : none;
}

std::vector<bool> used_accessors(const Json& document) {
  std::vector<bool> used(elements_of(document, "accessors").size());
  find_accessors(document, marking(used));
  return used;
}

std::vector<bool> used_views(const Json& document, const std::vector<bool>& accessors) {
  std::vector<bool> used(elements_of(document, "bufferViews").size());
  find_views(document, accessors, marking(used));
  return used;
}

void for_each_range(Json& document, const std::function<void(Json&)>& function) {
  if (const auto views = document.find("bufferViews"); views != document.end() && views->is_array()) {
    for (Json& view : *views) {
      if (is_range(view)) function(view);
    }
  }
  find_ranges_in_extensions(document, false, function);
}

std::set<std::string> extensions_in(const Json& document) {
  std::set<std::string> names;
  for_each_extension(document, [&](const std::string& name, const Json&) { names.insert(name); });
  return names;
}

bool needs_quantization(const Json& document) {
  const Json& accessors = elements_of(document, "accessors");
  const auto needs = [&](const Json* attributes, bool is_target) {
    if (!attributes || !attributes->is_object()) return false;
    const auto items = attributes->items();
    return std::any_of(items.begin(), items.end(), [&](const auto& item) {
      const std::optional<std::size_t> number = as_whole(item.value());
      return number && *number < accessors.size() && !is_plain_type(item.key(), accessors[*number], is_target);
    });
  };
  for (const Json& mesh : elements_of(document, "meshes")) {
    for (const Json& primitive : elements_of(mesh, "primitives")) {
      if (needs(member(primitive, "attributes"), false)) return true;
      for (const Json& target : elements_of(primitive, "targets")) {
        if (needs(&target, true)) return true;
      }
    }
  }
  return false;
}

}  // namespace whittle::gltf
