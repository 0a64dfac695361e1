#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_map>

#include "format/colors.hh"
#include "format/vertex_split.hh"
#include "obj/obj.hh"
#include "obj/obj_tags.hh"

namespace whittle::io {

namespace {

/// A name in one line.
std::string in_one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

/// The rows of `vt` or `vn`, and the number of the row of each wedge, from 1. Without a table, each wedge has a row;
/// otherwise each value has one, in the order of faces.
struct ValueRows {
  std::vector<Index> wedges;  ///< with the value of each row
  std::vector<Index> row_of_wedge;

  Index row_of(Index wedge) const { return row_of_wedge.empty() ? wedge + 1 : row_of_wedge[wedge]; }
};

/// \param value_of bytes of the value of a wedge
template <class ValueOf>
ValueRows rows_of(const IndexedMesh& mesh, std::size_t n_wedges, const ValueOf& value_of) {
  ValueRows rows;
  if (mesh.wedges.empty()) {
    for (Index w = 0; w < n_wedges; ++w) rows.wedges.push_back(w);
    return rows;
  }
  rows.row_of_wedge.resize(n_wedges, 0);
  std::unordered_map<std::string_view, Index> known;
  for (const Index w : mesh.wedges) {
    if (rows.row_of_wedge[w] != 0) continue;
    const auto [at, is_new] = known.try_emplace(value_of(w), static_cast<Index>(rows.wedges.size() + 1));
    if (is_new) rows.wedges.push_back(w);
    rows.row_of_wedge[w] = at->second;
  }
  return rows;
}

template <class Number>
std::string_view bytes_of(const Number* numbers, std::size_t n) {
  return {reinterpret_cast<const char*>(numbers), n * sizeof(Number)};
}

/// Writes `o`, `g`, `usemtl` and `s`, where they change from one face to the next.
class TagWriter {
 public:
  TagWriter(ByteSink& sink, const IndexedMesh& mesh, const FileNotes& notes) : sink_(sink), mesh_(mesh) {
    for (const char* const keyword : {obj_object, obj_group, obj_smoothing}) {
      Tag& tag = tags_.emplace_back();
      tag.keyword = keyword;
      const auto found =
          std::find_if(mesh.face_attributes.begin(), mesh.face_attributes.end(), [&](const Attribute& a) {
            return a.name == keyword && a.kind == AttributeKind::category && a.n_components == 1;
          });
      if (found != mesh.face_attributes.end()) tag.attribute = &*found;
      const auto names = notes.face_names.find(keyword);
      if (names != notes.face_names.end()) tag.names = &names->second;
    }
  }

  /// The face attributes that are written.
  bool has(const Attribute& attribute) const {
    return std::any_of(tags_.begin(), tags_.end(), [&](const Tag& tag) { return tag.attribute == &attribute; });
  }

  void write(std::size_t face) {
    for (std::size_t i = 0; i < tags_.size(); ++i) {
      if (i == 2 && !mesh_.face_groups.empty()) write_material(mesh_.face_groups[face]);
      write(tags_[i], face);
    }
  }

 private:
  struct Tag {
    std::string keyword;
    const Attribute* attribute = nullptr;
    const std::vector<std::string>* names = nullptr;
    std::optional<double> last;
  };

  void write(Tag& tag, std::size_t face) {
    const bool is_one = tag.attribute == nullptr && tag.names != nullptr && tag.names->size() == 1;
    if (tag.attribute == nullptr && !is_one) return;
    const double value = tag.attribute != nullptr ? tag.attribute->values[face] : 0;
    if (tag.last == value) return;
    const std::string name = name_of(tag, value);
    // Faces have no name, and no smoothing group, at first.
    const bool is_default = !tag.last && (name.empty() || name == "off");
    tag.last = value;
    if (is_default) return;
    sink_ << tag.keyword << " " << (name.empty() ? std::string("default") : name) << "\n";
  }

  static std::string name_of(const Tag& tag, double value) {
    const bool is_number = tag.keyword == obj_smoothing && tag.attribute != nullptr;
    if (is_number && value == 0) return "off";
    const bool is_named =
        !is_number && tag.names != nullptr && value >= 0 && value < static_cast<double>(tag.names->size());
    if (is_named) return in_one_line((*tag.names)[static_cast<std::size_t>(value)]);
    return std::to_string(static_cast<long long>(value));
  }

  void write_material(Index group) {
    if (last_material_ == group) return;
    const bool is_first = !last_material_;
    last_material_ = group;
    const bool is_named = group < mesh_.group_names.size();
    const std::string name = is_named ? in_one_line(mesh_.group_names[group]) : "group_" + std::to_string(group);
    if (is_first && name.empty()) return;
    sink_ << "usemtl" << (name.empty() ? "" : " ") << name << "\n";
  }

  ByteSink& sink_;
  const IndexedMesh& mesh_;
  std::vector<Tag> tags_;
  std::optional<Index> last_material_;
};

class ObjWriter {
 public:
  /// \param stored the vertices and corners to write: `mesh`, or its split
  ObjWriter(ByteSink& sink, const IndexedMesh& mesh, const IndexedMesh& stored, const FileNotes& notes)
      : sink_(sink), mesh_(mesh), stored_(stored), notes_(notes), tags_(sink, mesh, notes) {
    if (const auto texcoords = find_texcoords(mesh, 1, 3)) texcoords_ = &mesh.attributes[*texcoords];
  }

  bool writes(const Attribute& attribute) const { return tags_.has(attribute) || &attribute == texcoords_; }

  void write() {
    for (const std::string& library : notes_.material_libraries) sink_ << "mtllib " << in_one_line(library) << "\n";
    write_vertices();
    write_texcoords();
    write_normals();
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      tags_.write(f);
      write_face(f);
    }
  }

 private:
  void write_vertices() {
    for (std::size_t v = 0; v < stored_.positions.size(); ++v) {
      sink_ << "v";
      for (const double x : stored_.positions[v]) (sink_ << " ").number(x);
      for (std::size_t i = 0; i < 3 && !stored_.colors.empty(); ++i) (sink_ << " ").number(stored_.colors[v][i]);
      sink_ << "\n";
    }
  }

  void write_texcoords() {
    if (texcoords_ == nullptr) return;
    texcoord_rows_ = rows_of(mesh_, texcoords_->size(), [this](Index w) {
      return bytes_of(texcoords_->value(w).data(), texcoords_->n_components);
    });
    for (const Index w : texcoord_rows_.wedges) {
      sink_ << "vt";
      for (const double x : texcoords_->value(w)) {
        sink_ << " ";
        texcoords_->type == ScalarType::float32 ? sink_.number(static_cast<float>(x)) : sink_.number(x);
      }
      sink_ << "\n";
    }
  }

  void write_normals() {
    if (mesh_.normals.empty()) return;
    normal_rows_ =
        rows_of(mesh_, mesh_.normals.size(), [this](Index w) { return bytes_of(mesh_.normals[w].data(), 3); });
    for (const Index w : normal_rows_.wedges) {
      sink_ << "vn";
      for (const float x : mesh_.normals[w]) (sink_ << " ").number(x);
      sink_ << "\n";
    }
  }

  // "v", "v/t", "v//n" or "v/t/n". A face without any normal has no numbers of them.
  void write_face(std::size_t f) {
    const auto is_zero = [&](std::size_t c) {
      return mesh_.normals[mesh_.wedge(f, c)] == std::array<float, 3>{0, 0, 0};
    };
    const bool with_normals =
        !mesh_.normals.empty() && (mesh_.wedges.empty() || !is_zero(0) || !is_zero(1) || !is_zero(2));
    sink_ << "f";
    for (std::size_t c = 0; c < 3; ++c) {
      (sink_ << " ").number(std::uint64_t{stored_.faces[f][c]} + 1);
      if (texcoords_ != nullptr) (sink_ << "/").number(texcoord_rows_.row_of(mesh_.wedge(f, c)));
      if (with_normals) (sink_ << (texcoords_ != nullptr ? "/" : "//")).number(normal_rows_.row_of(mesh_.wedge(f, c)));
    }
    sink_ << "\n";
  }

  ByteSink& sink_;
  const IndexedMesh& mesh_;
  const IndexedMesh& stored_;
  const FileNotes& notes_;
  TagWriter tags_;
  const Attribute* texcoords_ = nullptr;
  ValueRows texcoord_rows_;
  ValueRows normal_rows_;
};

}  // namespace

void write_obj(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings) {
  if (has_opacity(mesh)) warnings.emplace_back("OBJ has no opacity: it is left out");
  const std::optional<IndexedMesh> split = split_for(mesh, {.normals = false, .colors = true, .attributes = {}});
  ObjWriter writer(sink, mesh, split ? *split : mesh, options.notes);
  const auto warn = [&](std::string_view what, const std::vector<Attribute>& attributes) {
    std::vector<std::string> lost;
    for (const Attribute& attribute : attributes) {
      if (!writer.writes(attribute)) lost.push_back(attribute.name);
    }
    warn_of_lost("OBJ", what, lost, warnings);
  };
  warn("vertex attribute", mesh.attributes);
  warn("face attribute", mesh.face_attributes);
  if (!options.notes.header_lines.empty() && options.notes.material_libraries.empty()) {
    warnings.emplace_back("OBJ names textures in a material library: those of the file are left out");
  }
  writer.write();
}

}  // namespace whittle::io
