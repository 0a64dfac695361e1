#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "document/json.hh"
#include "model/model.hh"
#include "pose/world_transforms.hh"
#include "whittle/gltf/asset.hh"
#include "write/output.hh"

namespace whittle::gltf {

struct Asset::Content {
  std::string bytes;             ///< the model points into them
  std::filesystem::path source;  ///< empty if it was read from memory
  std::filesystem::path folder;
  Json document;
  Model model;
  Rest rest;
  Replacements replacements;

  /// Makes the model of the document, and of the bytes. \param name of the file, for messages
  void read_document(const std::string& name);
  const Mesh& mesh(std::size_t number) const { return model.meshes.at(number); }
  /// The output to write. \throw std::invalid_argument if this build can't compress
  Output output(const Replacements& replaced, const WriteOptions& options) const;
};

}  // namespace whittle::gltf
