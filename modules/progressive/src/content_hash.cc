#include <xxhash.h>

#include <array>
#include <bit>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bytes.hh"

namespace whittle::progressive {
namespace {

class Hasher {
 public:
  Hasher() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

  template <class Number>
  void add(const Number* numbers, std::size_t n) {
    if constexpr (std::endian::native == std::endian::little) {
      XXH3_128bits_update(state_.get(), numbers, n * sizeof(Number));
    } else {
      for (std::size_t i = 0; i < n; ++i) {
        std::array<char, sizeof(Number)> bytes;
        store_little_endian(numbers[i], bytes.data());
        XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
      }
    }
  }
  /// An array of items of N numbers each, after its length.
  template <class Number, std::size_t N, class Item>
  void add_all(const std::vector<Item>& items) {
    static_assert(sizeof(Item) == N * sizeof(Number));
    const std::uint64_t n = items.size();
    add(&n, 1);
    if (n > 0) add(reinterpret_cast<const Number*>(items.data()), n * N);
  }
  void add_text(const std::string& text) {
    const std::uint64_t n = text.size();
    add(&n, 1);
    add(text.data(), text.size());
  }
  ContentHash hash() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return {hash.low64, hash.high64};
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

void add_attributes(Hasher& hasher, const std::vector<Attribute>& attributes) {
  const std::uint64_t n = attributes.size();
  hasher.add(&n, 1);
  for (const Attribute& attribute : attributes) {
    hasher.add_text(attribute.name);
    const std::array<std::uint64_t, 4> kind = {static_cast<std::uint64_t>(attribute.kind), attribute.n_components,
                                               static_cast<std::uint64_t>(attribute.type),
                                               attribute.is_normalized ? 1U : 0U};
    hasher.add(kind.data(), kind.size());
    hasher.add_all<double, 1>(attribute.values);
  }
}

}  // namespace

ContentHash content_hash(const IndexedMesh& mesh) {
  Hasher hasher;
  hasher.add_all<double, 3>(mesh.positions);
  hasher.add_all<Index, 3>(mesh.faces);
  hasher.add_all<float, 3>(mesh.normals);
  hasher.add_all<float, 4>(mesh.colors);
  hasher.add_all<Index, 1>(mesh.origins);
  // A mesh without these has the hash that it had before recordings had them.
  if (mesh.wedges.empty() && mesh.attributes.empty() && mesh.face_attributes.empty() && mesh.face_groups.empty()) {
    return hasher.hash();
  }
  hasher.add_all<Index, 1>(mesh.wedges);
  add_attributes(hasher, mesh.attributes);
  add_attributes(hasher, mesh.face_attributes);
  hasher.add_all<Index, 1>(mesh.face_groups);
  for (const std::string& name : mesh.group_names) hasher.add_text(name);
  return hasher.hash();
}

}  // namespace whittle::progressive
