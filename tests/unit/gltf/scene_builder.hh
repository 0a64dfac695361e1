#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "document/json.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf::test {

/// Makes small assets by hand: `json` is the document, and accessors get their numbers here.
struct SceneBuilder {
  Json json = {{"asset", {{"version", "2.0"}}}, {"accessors", Json::array()}, {"bufferViews", Json::array()}};
  std::string buffer;

  /// An accessor of 32-bit numbers. \param type "VEC3" \return its number
  std::size_t floats(const std::string& type, const std::vector<float>& numbers);
  /// One of unsigned 8-bit integers.
  std::size_t bytes(const std::string& type, const std::vector<std::size_t>& numbers);
  /// One of normalized signed 16-bit integers.
  std::size_t fractions(const std::string& type, const std::vector<int>& numbers);

  /// Adds an animation with one sampler and one channel. \return its number
  std::size_t animate(std::size_t node, const std::string& path, const std::vector<float>& times, std::size_t values,
                      const std::string& interpolation = "LINEAR");

  std::string glb() const;
  Asset asset() const { return Asset::read(glb(), "scene"); }

 private:
  std::size_t add(const std::string& type, int component_type, std::size_t n_numbers, const std::string& packed);
};

/// A bar along x from 0 to 2, in three vertices that are one flat triangle. Joint 0 is at the origin; joint 1, its
/// child, at x = 1. The vertices at x = 0, 1 and 2 are moved by joint 0, by both alike, and by joint 1. Nodes: 0 the
/// bar, which lies 100 along x; 1 and 2 the joints.
SceneBuilder bar();

/// A triangle (0 0 0, 1 0 0, 0 1 0) in a node with two morph targets: up by 1 along z, and vertex 1 by 4 along x.
SceneBuilder morphing_triangle();

}  // namespace whittle::gltf::test
