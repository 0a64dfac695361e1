#include <cmath>

#include "format/colors.hh"
#include "ply/ply.hh"

namespace whittle::io {

namespace {

// Whether 32 bits a coordinate lose nothing.
bool fits_float(const IndexedMesh& mesh) {
  for (const Vec3& p : mesh.positions) {
    for (const double x : p) {
      if (std::abs(x) > static_cast<double>(std::numeric_limits<float>::max())) return false;
      if (static_cast<double>(static_cast<float>(x)) != x) return false;
    }
  }
  return true;
}

class PlyWriter {
 public:
  PlyWriter(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options)
      : sink_(sink),
        mesh_(mesh),
        ascii_(options.ascii),
        as_float_(fits_float(mesh)),
        exact_colors_(options.exact_colors),
        color_components_(mesh.colors.empty() ? 0
                          : has_opacity(mesh) ? 4
                                              : 3) {}

  void write() {
    write_header();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) write_vertex(v);
    for (const Triangle& face : mesh_.faces) write_face(face);
  }

 private:
  void write_header() {
    sink_ << "ply\nformat " << (ascii_ ? "ascii" : "binary_little_endian") << " 1.0\ncomment written by whittle\n";
    sink_ << "element vertex ";
    sink_.number(mesh_.positions.size());
    sink_ << "\n";
    for (const char* const name : {"x", "y", "z"}) declare(as_float_ ? "float" : "double", name);
    if (!mesh_.normals.empty()) {
      for (const char* const name : {"nx", "ny", "nz"}) declare("float", name);
    }
    constexpr std::string_view colors[] = {"red", "green", "blue", "alpha"};
    for (std::size_t i = 0; i < color_components_; ++i) declare(exact_colors_ ? "float" : "uchar", colors[i]);
    sink_ << "element face ";
    sink_.number(mesh_.faces.size());
    sink_ << "\nproperty list uchar " << (index_fits_int() ? "int" : "uint") << " vertex_indices\nend_header\n";
  }

  void declare(std::string_view type, std::string_view name) { sink_ << "property " << type << " " << name << "\n"; }

  bool index_fits_int() const { return mesh_.positions.size() <= std::size_t{1} << 31; }

  void write_vertex(std::size_t v) {
    for (const double x : mesh_.positions[v]) {
      if (as_float_) {
        put(static_cast<float>(x));
      } else {
        put(x);
      }
    }
    for (std::size_t i = 0; i < 3 && !mesh_.normals.empty(); ++i) put(mesh_.normals[v][i]);
    for (std::size_t i = 0; i < color_components_; ++i) {
      if (exact_colors_) {
        put(mesh_.colors[v][i]);
      } else {
        put(static_cast<std::uint8_t>(to_byte(mesh_.colors[v][i])));
      }
    }
    end_row();
  }

  void write_face(const Triangle& face) {
    put(std::uint8_t{3});
    for (const Index v : face) put(v);
    end_row();
  }

  template <class Number>
  void put(Number value) {
    if (!ascii_) {
      sink_.little_endian(value);
      return;
    }
    if (!at_row_start_) sink_ << " ";
    at_row_start_ = false;
    sink_.number(value);
  }

  void end_row() {
    if (ascii_) sink_ << "\n";
    at_row_start_ = true;
  }

  ByteSink& sink_;
  const IndexedMesh& mesh_;
  bool ascii_;
  bool as_float_;
  bool exact_colors_;
  std::size_t color_components_;
  bool at_row_start_ = true;
};

}  // namespace

void write_ply(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options, std::vector<std::string>&) {
  PlyWriter(sink, mesh, options).write();
}

}  // namespace whittle::io
