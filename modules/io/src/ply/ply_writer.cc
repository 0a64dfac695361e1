#include <algorithm>
#include <cmath>
#include <optional>

#include "format/colors.hh"
#include "format/vertex_split.hh"
#include "ply/ply.hh"
#include "ply/ply_columns.hh"
#include "ply/ply_notes.hh"

namespace whittle::io {

namespace {

constexpr const char* corner_list = "vertex_indices";
constexpr const char* texcoord_list = "texcoord";

/// The attribute that is written as a list at faces: it came from there.
std::optional<std::size_t> find_texcoord_list(const IndexedMesh& mesh) {
  const std::optional<std::size_t> found = find_texcoords(mesh, 2, 2);
  return found && mesh.attributes[*found].name == texcoord_list ? found : std::nullopt;
}

/// Writes numbers as text or binary data, a row a line.
class RowSink {
 public:
  /// \param most_numbers in a row
  RowSink(ByteSink& sink, bool ascii, std::size_t most_numbers)
      : sink_(sink), ascii_(ascii), row_(ascii ? 0 : sizeof(double) * most_numbers) {}

  template <class Number>
  void put(Number value) {
    if (ascii_) {
      if (used_ > 0) sink_ << " ";
      used_ = 1;
      sink_.number(value);
    } else {
      store_little_endian(value, row_.data() + used_);
      used_ += sizeof value;
    }
  }

  void put(const PlyColumn& column, std::size_t row) {
    if (column.floats != nullptr) {
      put_all(column, column.floats + row * column.stride);
    } else {
      put_all(column, column.doubles + row * column.stride);
    }
  }

  void put(double value, ScalarType type, bool is_normalized) {
    if (type == ScalarType::float32) return put(static_cast<float>(value));
    if (type == ScalarType::float64) return put(value);
    const double stored = to_integer(value, type, is_normalized);
    switch (type) {
      case ScalarType::int8:
        return put(static_cast<std::int8_t>(stored));
      case ScalarType::uint8:
        return put(static_cast<std::uint8_t>(stored));
      case ScalarType::int16:
        return put(static_cast<std::int16_t>(stored));
      case ScalarType::uint16:
        return put(static_cast<std::uint16_t>(stored));
      case ScalarType::int32:
        return put(static_cast<std::int32_t>(stored));
      default:
        return put(static_cast<std::uint32_t>(stored));
    }
  }

  /// \param values `column.n_components` numbers
  template <class Real>
  void put_all(const PlyColumn& column, const Real* values) {
    const Real* const end = values + column.n_components;
    if (column.type == ScalarType::float32) {
      put_each<float>(values, end);
    } else if (column.type == ScalarType::float64) {
      put_each<double>(values, end);
    } else if (column.type == ScalarType::uint8 && column.floats != nullptr) {
      for (; values != end; ++values) put(static_cast<std::uint8_t>(to_byte(static_cast<float>(*values))));
    } else {
      for (; values != end; ++values) put(double{*values}, column.type, column.is_normalized);
    }
  }

  void end_row() {
    sink_ << (ascii_ ? std::string_view("\n") : std::string_view(row_.data(), used_));
    used_ = 0;
  }

  /// Likewise as numbers of one type.
  template <class Stored, class Number>
  void put_each(const Number* values, const Number* end) {
    if (ascii_) {
      for (; values != end; ++values) put(static_cast<Stored>(*values));
      return;
    }
    char* to = row_.data() + used_;
    used_ += sizeof(Stored) * static_cast<std::size_t>(end - values);
    for (; values != end; ++values, to += sizeof(Stored)) store_little_endian(static_cast<Stored>(*values), to);
  }

 private:
  ByteSink& sink_;
  bool ascii_;
  std::vector<char> row_;  // As binary data.
  std::size_t used_ = 0;   // Bytes of it. As text: whether the line has a number.
};

class PlyWriter {
 public:
  /// \param stored the vertices and corners to write: `mesh`, or its split
  PlyWriter(ByteSink& sink, const IndexedMesh& mesh, const IndexedMesh& stored, const WriteOptions& options)
      : sink_(sink), mesh_(mesh), stored_(stored), options_(options) {
    if (const auto list = find_texcoord_list(mesh)) texcoords_ = &mesh.attributes[*list];
    vertex_columns_ = vertex_columns(stored, options);
    if (texcoords_ != nullptr && &mesh == &stored) {
      std::erase_if(vertex_columns_, [&](const PlyColumn& column) {
        return column.doubles == texcoords_->values.data() || column.doubles == texcoords_->values.data() + 1;
      });
    }
    plan_faces();
  }

  void write() {
    write_header();
    const std::vector<PlyColumn> runs = runs_of(vertex_columns_);
    RowSink rows(sink_, options_.ascii, vertex_columns_.size());
    for (std::size_t v = 0; v < stored_.positions.size(); ++v) {
      for (const PlyColumn& run : runs) rows.put(run, v);
      rows.end_row();
    }
    write_faces();
  }

 private:
  struct FaceColumn {
    enum { corners, texcoords, scalar } what = scalar;
    PlyColumn column;
  };

  void plan_faces() {
    if (!mesh_.face_groups.empty()) {
      groups_.push_back({.name = group_property,
                         .kind = AttributeKind::category,
                         .values = {mesh_.face_groups.begin(), mesh_.face_groups.end()},
                         .type = ScalarType::int32});
    }
    const std::vector<std::string>& order = options_.notes.face_properties;
    const bool is_singular = std::find(order.begin(), order.end(), "vertex_index") != order.end();
    face_columns_.push_back({FaceColumn::corners, {.name = is_singular ? "vertex_index" : corner_list}});
    if (texcoords_ != nullptr) face_columns_.push_back({FaceColumn::texcoords, {.name = texcoord_list}});
    const auto add = [&](const std::vector<Attribute>& attributes) {
      for (PlyColumn& column : columns_of(attributes)) face_columns_.push_back({FaceColumn::scalar, std::move(column)});
    };
    add(mesh_.face_attributes);
    add(groups_);
    std::stable_sort(face_columns_.begin(), face_columns_.end(), [&](const FaceColumn& a, const FaceColumn& b) {
      return std::find(order.begin(), order.end(), a.column.name) <
             std::find(order.begin(), order.end(), b.column.name);
    });
  }

  void write_header() {
    sink_ << "ply\nformat " << (options_.ascii ? "ascii" : "binary_little_endian")
          << " 1.0\ncomment written by whittle\n";
    write_ply_notes(sink_, mesh_, options_.notes);
    sink_ << "element vertex ";
    sink_.number(stored_.positions.size());
    sink_ << "\n";
    for (const PlyColumn& column : vertex_columns_) declare(column);
    sink_ << "element face ";
    sink_.number(stored_.faces.size());
    sink_ << "\n";
    for (const auto& [what, column] : face_columns_) {
      if (what == FaceColumn::scalar) {
        declare(column);
      } else {
        const bool is_corners = what == FaceColumn::corners;
        sink_ << "property list uchar " << (is_corners ? index_type() : ply_name_of(texcoords_->type)) << " "
              << column.name << "\n";
      }
    }
    sink_ << "end_header\n";
  }

  void declare(const PlyColumn& column) {
    sink_ << "property " << ply_name_of(column.type) << " " << column.name << "\n";
  }

  std::string_view index_type() const { return stored_.positions.size() <= std::size_t{1} << 31 ? "int" : "uint"; }

  void write_faces() {
    constexpr std::size_t most_in_lists = 11;
    RowSink rows(sink_, options_.ascii, face_columns_.size() + most_in_lists);
    for (std::size_t f = 0; f < stored_.faces.size(); ++f) {
      for (const auto& [what, column] : face_columns_) {
        if (what == FaceColumn::corners) {
          rows.put(std::uint8_t{3});
          const Triangle& face = stored_.faces[f];
          rows.put_each<Index>(face.data(), face.data() + face.size());
        } else if (what == FaceColumn::scalar) {
          rows.put(column, f);
        } else {
          rows.put(std::uint8_t{6});
          for (std::size_t c = 0; c < 3; ++c) {
            for (const double x : texcoords_->value(mesh_.wedge(f, c))) rows.put(x, texcoords_->type, false);
          }
        }
      }
      rows.end_row();
    }
  }

  ByteSink& sink_;
  const IndexedMesh& mesh_;
  const IndexedMesh& stored_;
  const WriteOptions& options_;
  const Attribute* texcoords_ = nullptr;  // Written as a list at faces.
  std::vector<PlyColumn> vertex_columns_;
  std::vector<Attribute> groups_;  // One or none.
  std::vector<FaceColumn> face_columns_;
};

}  // namespace

void write_ply(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options, std::vector<std::string>&) {
  const std::optional<std::size_t> list = find_texcoord_list(mesh);
  VertexStorage storage{.normals = true, .colors = true, .attributes = {}};
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    if (i != list) storage.attributes.push_back(i);
  }
  const std::optional<IndexedMesh> split = split_for(mesh, storage);
  PlyWriter(sink, mesh, split ? *split : mesh, options).write();
}

}  // namespace whittle::io
