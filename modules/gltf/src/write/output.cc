#include "write/output.hh"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "codec/meshopt.hh"
#include "model/extensions.hh"
#include "write/merge.hh"
#include "write/new_geometry.hh"
#include "write/pack_buffers.hh"
#include "write/quantization.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

constexpr int vertex_target = 34962;
constexpr int index_target = 34963;

/// Numbers of accessors, or of views, that become free, and new ones after the last.
class Numbers {
 public:
  explicit Numbers(std::vector<bool> free) : free_(std::move(free)) {}

  std::optional<std::size_t> take_if_free(std::optional<std::size_t> number) {
    if (!number || *number >= free_.size() || !free_[*number]) return {};
    free_[*number] = false;
    return number;
  }

  std::size_t take_any() {
    const auto found = std::find(free_.begin() + static_cast<std::ptrdiff_t>(first_), free_.end(), true);
    first_ = static_cast<std::size_t>(found - free_.begin());
    if (found == free_.end()) free_.push_back(true);
    free_[first_] = false;
    return first_;
  }

 private:
  std::vector<bool> free_;
  std::size_t first_ = 0;  // none below is free
};

/// Objects used before, but not after.
std::vector<bool> freed(std::vector<bool> before, const std::vector<bool>& after) {
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = before[i] && !after[i];
  return before;
}

std::vector<bool> inverted(std::vector<bool> flags) {
  flags.flip();
  return flags;
}

void clear_elements(Json& document, const char* name, const std::vector<bool>& which) {
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (which[i]) document[name][i] = nullptr;
  }
}

void set_element(Json& document, const char* name, std::size_t number, Json value) {
  Json& elements = document[name];
  while (elements.size() <= number) elements.push_back(nullptr);
  elements[number] = std::move(value);
}

/// Drops cleared elements at the end of an array; others become `placeholder`, so that no number changes.
void fill_cleared(Json& document, const char* name, const Json& placeholder) {
  const auto elements = document.find(name);
  if (elements == document.end() || !elements->is_array()) return;
  while (!elements->empty() && elements->back().is_null()) elements->erase(elements->size() - 1);
  for (Json& element : *elements) {
    if (element.is_null()) element = placeholder;
  }
  if (elements->empty()) document.erase(name);
}

/// An accessor, with the name and the extras of the one that it replaces.
Json accessor_json(const Encoded& values, std::optional<std::size_t> view, const Json* old) {
  Json json = Json::object();
  if (view) json["bufferView"] = *view;
  json["componentType"] = component_type(values.type);
  if (values.is_normalized) json["normalized"] = true;
  json["count"] = values.count;
  json["type"] = name_of(values.shape);
  if (!values.low.empty()) {
    json["min"] = values.low;
    json["max"] = values.high;
  }
  for (const char* const kept : {"name", "extras", "extensions"}) {
    if (const Json* value = old ? member(*old, kept) : nullptr) json[kept] = *value;
  }
  return json;
}

void align(std::string& bytes, const Encoded& values) {
  const std::size_t multiple = std::max<std::size_t>(4, size_of(values.type));
  bytes.append((multiple - bytes.size() % multiple) % multiple, '\0');
}

/// Appends values to the buffer. \return their view
Json append_view(const NewAccessor& accessor, bool compress, PackedBuffers& to) {
  const Encoded& values = accessor.values;
  align(to.bytes, values);
  const bool are_indices = values.mode == MeshoptMode::triangles;
  Json view = {{"buffer", first_buffer}, {"byteOffset", to.bytes.size()}, {"byteLength", values.bytes.size()}};
  // Elements with something between them need a stride.
  if (!are_indices && values.stride != values.shape.packed_stride(values.type)) view["byteStride"] = values.stride;
  if (!accessor.skin) view["target"] = are_indices ? index_target : vertex_target;
  if (!compress) {
    to.bytes += values.bytes;
    return view;
  }
  const MeshoptLayout layout{values.count, values.stride, values.mode, values.filter};
  const std::string packed = encode_meshopt(layout, values.bytes);
  Json compression = {{"buffer", first_buffer},      {"byteOffset", to.bytes.size()}, {"byteLength", packed.size()},
                      {"byteStride", layout.stride}, {"count", layout.count},         {"mode", name_of(layout.mode)}};
  if (layout.filter != MeshoptFilter::none) compression["filter"] = name_of(layout.filter);
  view["buffer"] = fallback_buffer;
  view["byteOffset"] = to.n_fallback_bytes;
  view["extensions"][std::string(meshopt_extension)] = std::move(compression);
  to.bytes += packed;
  to.n_fallback_bytes += (values.bytes.size() + 3) / 4 * 4;
  return view;
}

/// Gives new accessors numbers: of the accessors that they replace, if unused otherwise, else other free ones.
std::vector<std::size_t> numbered(const std::vector<std::optional<std::size_t>>& wished, std::vector<bool> free) {
  Numbers numbers(std::move(free));
  std::vector<std::optional<std::size_t>> taken;
  taken.reserve(wished.size());
  for (const auto& wish : wished) taken.push_back(numbers.take_if_free(wish));
  std::vector<std::size_t> all;
  all.reserve(wished.size());
  for (const auto& number : taken) all.push_back(number ? *number : numbers.take_any());
  return all;
}

/// Puts new geometry in the place of replaced geometry. \param freed_* objects that the document doesn't use any more
void place_geometry(Json& document, const Json& old, const Model& model, const std::vector<NewAccessor>& accessors,
                    std::vector<bool> freed_accessors, std::vector<bool> freed_views, bool compress,
                    PackedBuffers& buffers) {
  std::vector<std::optional<std::size_t>> wished_accessors;
  std::vector<std::optional<std::size_t>> wished_views;
  for (const NewAccessor& accessor : accessors) {
    wished_accessors.push_back(accessor.old);
    if (accessor.has_bytes) wished_views.push_back(accessor.old ? model.accessors[*accessor.old].view : std::nullopt);
  }
  const std::vector<std::size_t> numbers = numbered(wished_accessors, std::move(freed_accessors));
  const std::vector<std::size_t> views = numbered(wished_views, std::move(freed_views));
  std::size_t n_views = 0;
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    std::optional<std::size_t> view;
    if (accessors[i].has_bytes) {
      view = views[n_views++];
      set_element(document, "bufferViews", *view, append_view(accessors[i], compress, buffers));
    }
    const Json* const replaced = accessors[i].old ? &old["accessors"][*accessors[i].old] : nullptr;
    set_element(document, "accessors", numbers[i], accessor_json(accessors[i].values, view, replaced));
    place_in(document, accessors[i]) = numbers[i];
  }
}

void remove_name(Json& document, const char* list, const std::string& name) {
  const auto names = document.find(list);
  if (names == document.end() || !names->is_array()) return;
  names->erase(std::remove(names->begin(), names->end(), Json(name)), names->end());
  if (names->empty()) document.erase(list);
}

void add_name(Json& document, const char* list, const std::string& name) {
  Json& names = document[list];
  if (std::find(names.begin(), names.end(), Json(name)) == names.end()) names.push_back(name);
}

/// Brings the lists of extensions up to date.
void list_extensions(Json& document, const Json& old, const WriteOptions& options) {
  const std::set<std::string> used = extensions_in(document);
  std::set<std::string> gone = extensions_in(old);
  for (const std::string& name : used) gone.erase(name);
  const bool is_quantized = needs_quantization(document);
  if (!is_quantized) gone.emplace(quantization_extension);
  for (const std::string& name : gone) {
    remove_name(document, "extensionsUsed", name);
    remove_name(document, "extensionsRequired", name);
  }
  const bool is_compressed = options.compress && used.contains(std::string(meshopt_extension));
  for (const char* const list : {"extensionsUsed", "extensionsRequired"}) {
    if (is_compressed) add_name(document, list, std::string(meshopt_extension));
    if (is_quantized && (is_compressed || options.quantize)) {
      add_name(document, list, std::string(quantization_extension));
    }
  }
}

std::vector<NewAccessor> all_new_accessors(const Json& old, const Model& model, const Replacements& replacements,
                                           const WriteOptions& options, const Quantization& quantization) {
  const auto packing_of = [&](std::size_t mesh) {
    Packing packing{options.compress, options.quantize, {}};
    const auto grid = quantization.of_mesh.find(mesh);
    if (grid != quantization.of_mesh.end()) {
      packing.grid = grid->second;
    } else if (options.compress) {
      packing.grid = grid_of(replacements.at(mesh));
    }
    return packing;
  };
  std::vector<NewAccessor> accessors = new_accessors(model, replacements, packing_of);
  std::vector<NewAccessor> of_skins = quantized_skins(old, model, quantization);
  accessors.insert(accessors.end(), std::move_iterator(of_skins.begin()), std::move_iterator(of_skins.end()));
  return accessors;
}

/// \return the number of bytes that other content has, at the beginning
std::size_t replace_geometry(Json& document, const Json& old, const Model& model, const Replacements& replacements,
                             const WriteOptions& options, PackedBuffers& buffers) {
  const Quantization quantization = options.quantize ? quantization_of(old, model, replacements) : Quantization{};
  strip_geometry(document, model, replacements);
  strip_skins(document, quantization);
  const std::vector<bool> freed_accessors = freed(used_accessors(old), used_accessors(document));
  const std::vector<bool> all(freed_accessors.size(), true);
  const std::vector<bool> freed_views = freed(used_views(old, all), used_views(document, inverted(freed_accessors)));
  clear_elements(document, "accessors", freed_accessors);
  clear_elements(document, "bufferViews", freed_views);
  buffers = pack_buffers(document, model);
  const std::size_t n_kept_bytes = buffers.bytes.size();
  place_geometry(document, old, model, all_new_accessors(old, model, replacements, options, quantization),
                 freed_accessors, freed_views, options.compress, buffers);
  place_grids(document, quantization);
  drop_lost_primitives(document, model, replacements);
  drop_empty_meshes(document, replacements);
  // A byte that any file with geometry has.
  fill_cleared(document, "bufferViews", {{"buffer", first_buffer}, {"byteLength", 1}});
  fill_cleared(document, "accessors",
               {{"componentType", component_type(ScalarType::uint8)}, {"count", 1}, {"type", "SCALAR"}});
  return n_kept_bytes;
}

}  // namespace

Output make_output(const Model& model, const Json& document, const Replacements& replacements,
                   const WriteOptions& options) {
  Output output{document, {}, 0};
  PackedBuffers buffers;
  if (replacements.empty()) {
    buffers = pack_buffers(output.document, model);
  } else {
    output.n_kept_bytes = replace_geometry(output.document, document, model, replacements, options, buffers);
  }
  list_buffers(output.document, model, buffers);
  if (!replacements.empty()) list_extensions(output.document, document, options);
  output.buffer = std::move(buffers.bytes);
  return output;
}

}  // namespace whittle::gltf
