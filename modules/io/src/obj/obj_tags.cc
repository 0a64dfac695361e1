#include "obj/obj_tags.hh"

#include <algorithm>
#include <charconv>
#include <unordered_map>
#include <utility>

namespace whittle::io {
namespace {

/// The names that faces have, in their first order, and the number of the name of each face. A face before the first
/// statement has the name "".
struct TaggedFaces {
  std::vector<std::string> names;
  std::vector<Index> of_faces;
};

class TagNumbers {
 public:
  Index number_of(const std::string& name) {
    const auto [at, is_new] = numbers_.try_emplace(name, static_cast<Index>(names_.size()));
    if (is_new) names_.push_back(name);
    return at->second;
  }
  std::vector<std::string> take_names() { return std::move(names_); }

 private:
  std::unordered_map<std::string, Index> numbers_;
  std::vector<std::string> names_;
};

TaggedFaces tagged_faces(const std::vector<ObjSwitch>& switches, ObjTag tag, std::size_t n_faces) {
  TaggedFaces tagged;
  tagged.of_faces.reserve(n_faces);
  TagNumbers numbers;
  std::string name;
  const auto fill_up_to = [&](std::size_t face) {
    if (face > tagged.of_faces.size()) tagged.of_faces.resize(face, numbers.number_of(name));
  };
  for (const ObjSwitch& change : switches) {
    if (change.tag != tag) continue;
    fill_up_to(change.first_face);
    name = change.name;
  }
  fill_up_to(n_faces);
  tagged.names = numbers.take_names();
  return tagged;
}

bool has_tag(const std::vector<ObjSwitch>& switches, ObjTag tag) {
  return std::any_of(switches.begin(), switches.end(), [tag](const ObjSwitch& change) { return change.tag == tag; });
}

/// The number of a smoothing group; 0 for "off" and other words.
double smoothing_number(const std::string& name) {
  Index number = 0;
  std::from_chars(name.data(), name.data() + name.size(), number);
  return number;
}

void add_attribute(MeshBuilder& builder, const char* name, std::vector<double> values) {
  builder.mesh().face_attributes.push_back({.name = name,
                                            .kind = AttributeKind::category,
                                            .n_components = 1,
                                            .values = std::move(values),
                                            .type = ScalarType::uint32});
}

}  // namespace

void ObjTags::add(const ObjChunk& chunk, std::size_t n_faces_before) {
  for (const ObjSwitch& change : chunk.switches()) {
    switches_.push_back(change);
    switches_.back().first_face += n_faces_before;
  }
  libraries_.insert(libraries_.end(), chunk.libraries().begin(), chunk.libraries().end());
}

void ObjTags::give_to(MeshBuilder& builder) const {
  builder.notes().material_libraries = libraries_;
  IndexedMesh& mesh = builder.mesh();
  const std::size_t n_faces = builder.face_count();
  if (has_tag(switches_, ObjTag::material)) {
    TaggedFaces materials = tagged_faces(switches_, ObjTag::material, n_faces);
    mesh.group_names = std::move(materials.names);
    mesh.face_groups = std::move(materials.of_faces);
  }
  for (const auto& [tag, attribute] : {std::pair(ObjTag::object, obj_object), std::pair(ObjTag::group, obj_group)}) {
    if (!has_tag(switches_, tag)) continue;
    TaggedFaces tagged = tagged_faces(switches_, tag, n_faces);
    if (tagged.names.size() > 1) add_attribute(builder, attribute, {tagged.of_faces.begin(), tagged.of_faces.end()});
    builder.notes().face_names[attribute] = std::move(tagged.names);
  }
  if (!has_tag(switches_, ObjTag::smoothing)) return;
  const TaggedFaces tagged = tagged_faces(switches_, ObjTag::smoothing, n_faces);
  std::vector<double> values(n_faces);
  for (std::size_t f = 0; f < n_faces; ++f) values[f] = smoothing_number(tagged.names[tagged.of_faces[f]]);
  const bool is_one = std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
  if (!is_one) return add_attribute(builder, obj_smoothing, std::move(values));
  if (!values.empty() && values.front() != 0) builder.notes().face_names[obj_smoothing] = {tagged.names.front()};
}

}  // namespace whittle::io
