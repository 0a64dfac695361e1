#include "repair/duplicate_faces.hh"

#include <algorithm>
#include <compare>

#include "whittle/core/two_sided.hh"

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

std::vector<char> find_duplicate_faces(std::span<const Triangle> faces, std::size_t vertices, unsigned threads) {
  std::vector<char> is_duplicate(faces.size(), 0);
  std::vector<Turned> compared;
  for (const Index f : faces_that_may_coincide(faces, vertices, threads)) compared.push_back(turned(faces[f], f));
  mark_duplicates(compared, is_duplicate);
  return is_duplicate;
}

}  // namespace whittle::io
