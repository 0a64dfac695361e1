#include "attributes/face_attributes.hh"

#include <utility>

namespace whittle {

void carry_face_attributes(const IndexedMesh& input, std::span<const Index> face_origins, IndexedMesh& mesh) {
  mesh.face_attributes.clear();
  for (const Attribute& from : input.face_attributes) {
    Attribute to = from.without_values();
    for (const Index f : face_origins) {
      const std::span<const double> value = from.value(f);
      to.values.insert(to.values.end(), value.begin(), value.end());
    }
    mesh.face_attributes.push_back(std::move(to));
  }
  mesh.face_groups.clear();
  if (input.face_groups.empty()) return;
  for (const Index f : face_origins) mesh.face_groups.push_back(input.face_groups[f]);
  mesh.group_names = input.group_names;
}

}  // namespace whittle
