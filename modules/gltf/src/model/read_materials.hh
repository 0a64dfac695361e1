#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "document/json.hh"
#include "model/model.hh"
#include "model/read_model.hh"
#include "whittle/core/material/material.hh"

namespace whittle::gltf {

/// Reads materials of a document, and each of their images once.
class MaterialReader {
 public:
  /// \param source outlives the reader, as the others do
  MaterialReader(const Model& model, const Json& document, const Source& source)
      : model_(model), source_(source), root_(document, "", source.file) {}

  /// \throw io::ReadError if there is no such material, or it is wrong
  Material read(std::size_t number);

 private:
  Part element(std::string_view key, std::string_view label, std::size_t number) const;
  void read_base_color(const std::optional<Part>& shading, std::string_view factor, std::string_view texture,
                       Material& material);
  std::optional<Texture> read_texture(const Part& info);
  std::shared_ptr<const Image> image(std::size_t number);
  void read_image(std::size_t number, Image& image) const;

  const Model& model_;
  const Source& source_;
  Part root_;
  std::map<std::size_t, std::shared_ptr<const Image>> images_;
};

}  // namespace whittle::gltf
