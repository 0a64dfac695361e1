#pragma once

#include <cstddef>
#include <string>

#include "document/json.hh"
#include "model/model.hh"
#include "model/read_model.hh"
#include "whittle/gltf/material.hh"

namespace whittle::gltf {

/// A material of the document. \throw io::ReadError if there is no such material, or it is wrong
Material read_material(const Part& root, std::size_t number);

/// The bytes of an image file. \throw io::ReadError if it isn't there
std::string read_image_bytes(const Model& model, const Part& root, std::size_t number, const Source& source);

}  // namespace whittle::gltf
