#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "format/vertex_split.hh"
#include "stl/stl.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::io {

namespace {

// Zero for a face without area. The corners are scaled first, so that products neither overflow nor vanish.
Vec3 normal_of(const Corners& corners) {
  const Vec3 a = corners[1] - corners[0];
  const Vec3 b = corners[2] - corners[0];
  const double scale = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  if (!(scale > 0) || !std::isfinite(scale)) return Vec3::Zero();
  const Vec3 normal = (a / scale).cross(b / scale);
  const double length = normal.norm();
  if (!(length > 0)) return Vec3::Zero();
  return normal / length;
}

void write_ascii(ByteSink& sink, const IndexedMesh& mesh) {
  const auto put = [&](const Vec3& p) {
    for (const double x : p) (sink << " ").number(x);
    sink << "\n";
  };
  sink << "solid whittle\n";
  for (const Triangle& face : mesh.faces) {
    const auto corners = corners_of(mesh.positions, face);
    sink << "facet normal";
    for (const double x : normal_of(corners)) (sink << " ").number(static_cast<float>(x));
    sink << "\n";
    sink << "outer loop\n";
    for (const Vec3& corner : corners) {
      sink << "vertex";
      put(corner);
    }
    sink << "endloop\nendfacet\n";
  }
  sink << "endsolid whittle\n";
}

void write_binary(ByteSink& sink, const IndexedMesh& mesh) {
  std::string header = "binary STL written by whittle";  // "solid" would begin a text file
  header.resize(stl_header_bytes, ' ');
  if (mesh.faces.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::range_error("binary STL can't hold as many faces");
  }
  sink << header;
  sink.little_endian(static_cast<std::uint32_t>(mesh.faces.size()));
  const auto put = [&](const Vec3& p) {
    for (const double x : p) sink.little_endian(static_cast<float>(x));
  };
  for (const Triangle& face : mesh.faces) {
    const auto corners = corners_of(mesh.positions, face);
    put(normal_of(corners));
    for (const Vec3& corner : corners) {
      if (corner.cwiseAbs().maxCoeff() > static_cast<double>(std::numeric_limits<float>::max())) {
        throw std::range_error("a coordinate is too large for the 32 bits of binary STL; write PLY, OBJ or ASCII STL");
      }
      put(corner);
    }
    sink.little_endian(std::uint16_t{0});
  }
}

// A mesh near the origin loses nearly nothing: losses above a millionth of its size are reported.
void warn_of_rounding(const IndexedMesh& mesh, const FileNotes& notes, std::vector<std::string>& warnings) {
  if (notes.has_float32_positions) return;
  const double error = float32_error(mesh.positions);
  if (error <= 1e-6 * diagonal_of(mesh.positions)) return;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "binary STL has 32 bits a coordinate, too few so far from the origin: positions are rounded by up to "
       << std::setprecision(2) << error << "; ASCII STL, PLY and OBJ keep all digits";
  warnings.push_back(text.str());
}

}  // namespace

void write_stl(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
               std::vector<std::string>& warnings) {
  if (!mesh.normals.empty()) warnings.emplace_back("STL has no vertex normals: they are left out");
  if (!mesh.colors.empty()) warnings.emplace_back("STL has no vertex colours: they are left out");
  warn_of_lost("STL", "vertex attribute", names_of_others(mesh.attributes, std::nullopt), warnings);
  warn_of_lost("STL", "face attribute", names_of_others(mesh.face_attributes, std::nullopt), warnings);
  warn_of_lost_groups("STL", mesh, options.notes, warnings);
  if (options.ascii) {
    write_ascii(sink, mesh);
  } else {
    write_binary(sink, mesh);
    warn_of_rounding(mesh, options.notes, warnings);
  }
}

}  // namespace whittle::io
