#include "repair/duplicate_faces.hh"

#include <algorithm>
#include <compare>
#include <cstdint>

#include "whittle/core/detail/item_groups.hh"
#include "whittle/core/detail/large_array.hh"

namespace whittle::io {

namespace {

// A face by its corners, the lowest one first.
struct Turned {
  Index lowest, second, third;
  Index face;
  auto operator<=>(const Turned&) const = default;
};

Turned turned(const Triangle& face, Index number) {
  const auto at = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  return {face[at], face[(at + 1) % 3], face[(at + 2) % 3], number};
}

Index lowest_of(const Triangle& face) { return std::min(std::min(face[0], face[1]), face[2]); }

// A hash of 64 bits, equal for faces with the same corners in any order.
std::uint64_t mark_of(const Triangle& face) {
  const std::uint64_t all = std::uint64_t{face[0]} + face[1] + face[2];
  return std::uint64_t{1} << (all * 0x9E3779B97F4A7C15U >> 58);  // Fibonacci hashing (Knuth, TAOCP 3, 6.4)
}

void mark_duplicates(std::vector<Turned>& faces, std::vector<char>& is_duplicate) {
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const Turned& face = faces[i];
    const Turned& last = faces[i - 1];
    const bool is_same = face.lowest == last.lowest && face.second == last.second && face.third == last.third;
    if (is_same) is_duplicate[face.face] = 1;
  }
}

}  // namespace

// Each vertex has the marks of faces whose lowest corner it is. Faces with equal marks are compared.
std::vector<char> find_duplicate_faces(std::span<const Triangle> faces, std::size_t vertices, unsigned threads) {
  LargeArray<std::uint64_t> marks(vertices, 0);
  std::vector<std::uint8_t> has_equal_marks(vertices);
  std::vector<char> is_duplicate(faces.size(), 0);
  const auto look_at = [&](Index begin, Index end, const auto& for_each_face) {
    const auto for_each_own = [&](const auto& use) {
      for_each_face([&](Index f) {
        const Index lowest = lowest_of(faces[f]);
        if (lowest >= begin && lowest < end && has_three_corners(faces[f])) use(f, lowest);
      });
    };
    bool is_any_equal = false;
    for_each_own([&](Index f, Index lowest) {
      const std::uint64_t mark = mark_of(faces[f]);
      if ((marks[lowest] & mark) != 0) {
        has_equal_marks[lowest] = 1;
        is_any_equal = true;
      }
      marks[lowest] |= mark;
    });
    if (!is_any_equal) return;
    std::vector<Turned> compared;
    for_each_own([&](Index f, Index lowest) {
      if (has_equal_marks[lowest] != 0) compared.push_back(turned(faces[f], f));
    });
    mark_duplicates(compared, is_duplicate);
  };
  whittle::detail::for_each_vertex_range(faces, vertices, threads, look_at);
  return is_duplicate;
}

}  // namespace whittle::io
