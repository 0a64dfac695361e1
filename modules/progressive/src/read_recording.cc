#include <algorithm>
#include <cctype>
#include <istream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bytes.hh"
#include "chunks.hh"
#include "whittle/core/detail/checks.hh"

namespace whittle::progressive {
namespace {

void require(bool is_so, const char* what) {
  if (!is_so) throw RecordingError(std::string("it is damaged: ") + what);
}

Vec3 read_position(ByteReader& reader) {
  const auto x = reader.number<double>();
  const auto y = reader.number<double>();
  const auto z = reader.number<double>();
  return {x, y, z};
}

Vec3 read_single_position(ByteReader& reader) {
  const auto x = reader.number<float>();
  const auto y = reader.number<float>();
  const auto z = reader.number<float>();
  return {x, y, z};
}

template <std::size_t N>
void read_floats(ByteReader& reader, std::uint64_t n, std::vector<std::array<float, N>>& values) {
  for (std::uint64_t i = 0; i < n; ++i) {
    auto& value = values.emplace_back();
    for (float& number : value) number = reader.number<float>();
  }
}

/// \param end upper bound, exclusive
void read_indices(ByteReader& reader, std::uint64_t n, std::uint64_t end, std::vector<Index>& indices) {
  Index last = 0;
  for (std::uint64_t i = 0; i < n; ++i) indices.push_back(last = reader.index_after(last, end));
}

/// Takes chunks in their order.
class RecordingReader {
 public:
  /// \return whether another chunk follows
  bool take(const Chunk& chunk);
  Recording end();

 private:
  void read_head(ByteReader& reader);
  void read_vertices(ByteReader& reader, std::uint64_t n);
  void read_faces(ByteReader& reader, std::uint64_t n);
  void read_note(ByteReader& reader, std::uint64_t n);
  void read_attribute(ByteReader& reader);
  void read_values(ByteReader& reader, std::uint64_t n);
  void read_contractions(ByteReader& reader, std::uint64_t n);
  void read_moved(ByteReader& reader, std::uint64_t n);
  void read_turned(ByteReader& reader, std::uint64_t n);
  void read_elements(const std::string& type, ByteReader& reader, std::uint64_t n);
  Triangle read_corners(ByteReader& reader, Index last) const;
  IndexedMesh& mesh();
  PassEnd& last_pass();
  /// \throw RecordingError
  void check_input(const IndexedMesh& mesh) const;

  Recording recording_;
  std::vector<Attribute>* attributes_ = nullptr;  ///< where the last one is
  bool has_head_ = false;
  std::uint64_t n_contractions_ = 0;  ///< number expected
  std::uint64_t n_pass_ends_ = 0;     ///< number expected
};

bool RecordingReader::take(const Chunk& chunk) {
  ByteReader reader(chunk.payload);
  if (chunk.type == "END ") {
    require(has_head_ && chunk.payload.empty(), "a part is not where it should be");
    return false;
  }
  const bool is_optional = std::islower(static_cast<unsigned char>(chunk.type[0])) != 0;
  if (is_optional && chunk.type != "note") return true;
  require(has_head_ != (chunk.type == "HEAD"), "a part is not where it should be");
  if (chunk.type == "HEAD") {
    read_head(reader);
  } else if (chunk.type == "CREA") {
    const auto angle_deg = reader.number<double>();
    require(angle_deg > 0 && angle_deg <= 180, "an angle of creases that can't be one");
    recording_.steps.crease_angle_deg = angle_deg;
  } else if (chunk.type == "PASS") {
    recording_.steps.pass_ends.push_back({recording_.steps.contractions.size(), {}, {}});
  } else {
    const std::uint64_t n = reader.count();
    require(n <= chunk.payload.size(), "a part has too few bytes");
    read_elements(chunk.type, reader, n);
  }
  require(reader.is_at_end(), "a part has too many bytes");
  return true;
}

void RecordingReader::read_head(ByteReader& reader) {
  has_head_ = true;
  recording_.n_vertices = reader.count();
  recording_.n_faces = reader.count();
  require(recording_.n_vertices < invalid_index && recording_.n_faces < invalid_index, "too many vertices or faces");
  n_contractions_ = reader.count();
  n_pass_ends_ = reader.count();
  for (std::uint64_t& part : recording_.hash) part = reader.number<std::uint64_t>();
  const auto normals = reader.number<std::uint8_t>();
  require(normals <= static_cast<std::uint8_t>(Normals::drop), "an unknown rule for normals");
  recording_.normals = static_cast<Normals>(normals);
  const auto flags = reader.number<std::uint8_t>();
  require(flags <= 3, "an unknown flag");
  if (flags % 2 == 1) recording_.input.emplace();
  recording_.steps.fits_attributes = flags / 2 == 1;
  recording_.about = reader.text(reader.count());
}

void RecordingReader::read_elements(const std::string& type, ByteReader& reader, std::uint64_t n) {
  if (type == "VERT") {
    read_vertices(reader, n);
  } else if (type == "FACE") {
    read_faces(reader, n);
  } else if (type == "NORM") {
    read_floats(reader, n, mesh().normals);
  } else if (type == "COLR") {
    read_floats(reader, n, mesh().colors);
  } else if (type == "ORIG") {
    read_indices(reader, n, invalid_index, mesh().origins);
  } else if (type == "WEDG") {
    read_indices(reader, n, 3 * recording_.n_faces, mesh().wedges);
  } else if (type == "GRUP") {
    read_indices(reader, n, invalid_index, mesh().face_groups);
  } else if (type == "NAME") {
    for (std::uint64_t i = 0; i < n; ++i) mesh().group_names.emplace_back(reader.text(reader.count()));
  } else if (type == "note") {
    read_note(reader, n);
  } else if (type == "ATTR") {
    for (std::uint64_t i = 0; i < n; ++i) read_attribute(reader);
  } else if (type == "VALU") {
    read_values(reader, n);
  } else if (type == "STEP") {
    read_contractions(reader, n);
  } else if (type == "MOVE") {
    read_moved(reader, n);
  } else if (type == "TURN") {
    read_turned(reader, n);
  } else {
    throw RecordingError("it has a part that only a later version of whittle can read");
  }
}

IndexedMesh& RecordingReader::mesh() {
  require(recording_.input.has_value(), "it has a part of a mesh that it says isn't there");
  return *recording_.input;
}

void RecordingReader::read_vertices(ByteReader& reader, std::uint64_t n) {
  const auto is_single = reader.number<std::uint8_t>();
  require(is_single <= 1, "an unknown flag");
  for (std::uint64_t i = 0; i < n; ++i) {
    mesh().positions.push_back(is_single == 1 ? read_single_position(reader) : read_position(reader));
  }
}

Triangle RecordingReader::read_corners(ByteReader& reader, Index last) const {
  Triangle corners{};
  corners[0] = reader.index_after(last, recording_.n_vertices);
  corners[1] = reader.index_after(corners[0], recording_.n_vertices);
  corners[2] = reader.index_after(corners[0], recording_.n_vertices);
  return corners;
}

void RecordingReader::read_faces(ByteReader& reader, std::uint64_t n) {
  Index last = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    mesh().faces.push_back(read_corners(reader, last));
    last = mesh().faces.back()[0];
  }
}

/// More texts of a name.
void RecordingReader::read_note(ByteReader& reader, std::uint64_t n) {
  require(n > 0, "a note without texts");
  std::vector<std::string>& texts = recording_.notes[std::string(reader.text(reader.count()))];
  for (std::uint64_t i = 0; i < n; ++i) texts.emplace_back(reader.text(reader.count()));
}

void RecordingReader::read_attribute(ByteReader& reader) {
  const auto flags = reader.number<std::uint8_t>();
  const auto kind = reader.number<std::uint8_t>();
  const auto type = reader.number<std::uint8_t>();
  require(flags <= 3 && kind <= static_cast<std::uint8_t>(AttributeKind::category) &&
              type <= static_cast<std::uint8_t>(ScalarType::float64),
          "an unknown kind of attribute");
  attributes_ = flags % 2 == 1 ? &mesh().face_attributes : &mesh().attributes;
  Attribute& attribute = attributes_->emplace_back();
  attribute.is_normalized = flags / 2 == 1;
  attribute.kind = static_cast<AttributeKind>(kind);
  attribute.type = static_cast<ScalarType>(type);
  attribute.n_components = reader.count();
  require(attribute.n_components > 0 && attribute.n_components < invalid_index, "an attribute without components");
  attribute.name = reader.text(reader.count());
}

/// Reads values of the last attribute.
void RecordingReader::read_values(ByteReader& reader, std::uint64_t n) {
  require(attributes_ != nullptr, "a part is not where it should be");
  const auto is_single = reader.number<std::uint8_t>();
  require(is_single <= 1, "an unknown flag");
  std::vector<double>& values = attributes_->back().values;
  for (std::uint64_t i = 0; i < n; ++i) {
    values.push_back(is_single == 1 ? static_cast<double>(reader.number<float>()) : reader.number<double>());
  }
}

void RecordingReader::read_contractions(ByteReader& reader, std::uint64_t n) {
  std::vector<Contraction>& contractions = recording_.steps.contractions;
  const std::size_t begin = contractions.size();
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::uint64_t removed_and_kind = reader.count();
    require(removed_and_kind >> 2 < recording_.n_vertices, "a vertex number is out of range");
    const auto removed = static_cast<Index>(removed_and_kind >> 2);
    const Index survivor = reader.index_after(removed, recording_.n_vertices);
    contractions.push_back(
        {survivor, removed, Vec3::Zero(), 0, (removed_and_kind & 1) != 0, (removed_and_kind & 2) != 0});
  }
  for (std::size_t i = begin; i < contractions.size(); ++i) contractions[i].position = read_position(reader);
  for (std::size_t i = begin; i < contractions.size(); ++i) contractions[i].cost = reader.number<double>();
}

PassEnd& RecordingReader::last_pass() {
  std::vector<PassEnd>& ends = recording_.steps.pass_ends;
  require(!ends.empty() && ends.back().n_contractions == recording_.steps.contractions.size(),
          "a part is not where it should be");
  return ends.back();
}

void RecordingReader::read_moved(ByteReader& reader, std::uint64_t n) {
  std::vector<PassEnd::MovedVertex>& moved = last_pass().moved;
  const std::size_t begin = moved.size();
  Index last = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    last = reader.index_after(last, recording_.n_vertices);
    moved.push_back({last, Vec3::Zero()});
  }
  for (std::size_t i = begin; i < moved.size(); ++i) moved[i].position = read_position(reader);
}

void RecordingReader::read_turned(ByteReader& reader, std::uint64_t n) {
  std::vector<PassEnd::TurnedFace>& turned = last_pass().turned;
  Index last = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    last = reader.index_after(last, recording_.n_faces);
    turned.push_back({last, read_corners(reader, 0)});
  }
}

Recording RecordingReader::end() {
  require(recording_.steps.contractions.size() == n_contractions_ && recording_.steps.pass_ends.size() == n_pass_ends_,
          "it has more or fewer steps than it says");
  if (recording_.input) check_input(*recording_.input);
  return std::move(recording_);
}

void RecordingReader::check_input(const IndexedMesh& mesh) const {
  require(mesh.positions.size() == recording_.n_vertices && mesh.faces.size() == recording_.n_faces &&
              (mesh.origins.empty() || mesh.origins.size() == mesh.positions.size()),
          "its mesh has more or fewer vertices or faces than it says");
  const auto is_group = [&](Index group) { return group < mesh.group_names.size(); };
  require(std::all_of(mesh.face_groups.begin(), mesh.face_groups.end(), is_group), "a group without a name");
  try {
    check_attributes(mesh, "recording");
  } catch (const std::invalid_argument& error) {
    throw RecordingError("it is damaged: " + std::string(error.what()));
  }
  require(content_hash(mesh) == recording_.hash, "its mesh is not the one that was written");
}

}  // namespace

Recording read_recording(std::istream& in) {
  read_signature(in);
  RecordingReader reader;
  while (reader.take(read_chunk(in))) {
  }
  if (in.peek() != std::istream::traits_type::eof()) throw RecordingError("it is damaged: bytes follow its end");
  return reader.end();
}

}  // namespace whittle::progressive
