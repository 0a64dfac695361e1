#include <xxhash.h>

#include <memory>
#include <span>
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
        const Number number = in_file_order(numbers[i]);
        XXH3_128bits_update(state_.get(), &number, sizeof(number));
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
  ContentHash hash() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return {hash.low64, hash.high64};
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

}  // namespace

ContentHash content_hash(const IndexedMesh& mesh) {
  Hasher hasher;
  hasher.add_all<double, 3>(mesh.positions);
  hasher.add_all<Index, 3>(mesh.faces);
  hasher.add_all<float, 3>(mesh.normals);
  hasher.add_all<float, 4>(mesh.colors);
  hasher.add_all<Index, 1>(mesh.origins);
  return hasher.hash();
}

}  // namespace whittle::progressive
