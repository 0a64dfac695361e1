#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "document/json.hh"

// References of a document to accessors, buffer views and buffers. Unchecked parts of the document, such as animations,
// may be invalid: values that don't follow the specification are ignored.

namespace whittle::gltf {

/// Each accessor that something refers to. Each whole number in an extension that isn't known may be one.
std::vector<bool> used_accessors(const Json& document);

/// Each buffer view that something refers to; accessors only if they are in `accessors`. Likewise.
std::vector<bool> used_views(const Json& document, const std::vector<bool>& accessors);

/// Calls `function` with each object that has a range of bytes in a buffer: "buffer", "byteOffset", "byteLength". These
/// are buffer views, and parts of extensions.
void for_each_range(Json& document, const std::function<void(Json&)>& function);

/// The extensions that objects of the document have.
std::set<std::string> extensions_in(const Json& document);

/// Whether attributes of primitives have types that only KHR_mesh_quantization allows.
bool needs_quantization(const Json& document);

/// Whether a material has a thickness (KHR_materials_volume), which is a length in the coordinates of its meshes.
bool has_thickness(const Json& material);

/// The elements of an array; none where there is no array of that name.
const Json& elements_of(const Json& object, std::string_view name);

}  // namespace whittle::gltf
