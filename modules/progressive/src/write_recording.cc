#include <algorithm>
#include <bit>
#include <functional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <vector>

#include "bytes.hh"
#include "chunks.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::progressive {
namespace {

/// Elements of a chunk.
constexpr std::size_t most_elements = 65536;
constexpr std::size_t most_about = 1'000'000;  ///< bytes of a text

/// A chunk to be written.
struct ChunkToWrite {
  std::string_view type;
  std::function<void(ByteWriter&)> write_payload;
};

bool is_float(double x) {
  return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(x))) == std::bit_cast<std::uint64_t>(x);
}

/// A number at a time: GCC 12 compiles the comparison of two vectors, a coordinate after the other, wrongly with -O2.
bool has_float_coordinates(const Vec3& p) { return is_float(p.x()) && is_float(p.y()) && is_float(p.z()); }

void write_position(ByteWriter& writer, const Vec3& p) {
  for (int i = 0; i < 3; ++i) writer.number(p[i]);
}

/// In single precision where that keeps every bit.
void write_positions(ByteWriter& writer, std::span<const Vec3> positions) {
  const bool are_single = std::all_of(positions.begin(), positions.end(), has_float_coordinates);
  writer.number(static_cast<std::uint8_t>(are_single ? 1 : 0));
  for (const Vec3& p : positions) {
    if (!are_single) write_position(writer, p);
    for (int i = 0; are_single && i < 3; ++i) writer.number(static_cast<float>(p[i]));
  }
}

std::int64_t difference(Index to, Index from) { return std::int64_t{to} - std::int64_t{from}; }

void write_corners(ByteWriter& writer, const Triangle& corners, Index last) {
  writer.difference(difference(corners[0], last));
  writer.difference(difference(corners[1], corners[0]));
  writer.difference(difference(corners[2], corners[0]));
}

void write_faces(ByteWriter& writer, std::span<const Triangle> faces) {
  Index last = 0;
  for (const Triangle& face : faces) {
    write_corners(writer, face, last);
    last = face[0];
  }
}

template <std::size_t N>
void write_floats(ByteWriter& writer, std::span<const std::array<float, N>> values) {
  for (const auto& value : values) {
    for (const float number : value) writer.number(number);
  }
}

void write_indices(ByteWriter& writer, std::span<const Index> indices) {
  Index last = 0;
  for (const Index index : indices) {
    writer.difference(difference(index, last));
    last = index;
  }
}

void write_text(ByteWriter& writer, std::string_view text) {
  writer.count(text.size());
  writer.text(text);
}

/// In single precision where that keeps every bit.
void write_values(ByteWriter& writer, std::span<const double> values) {
  const bool are_single = std::all_of(values.begin(), values.end(), is_float);
  writer.number(static_cast<std::uint8_t>(are_single ? 1 : 0));
  for (const double x : values) {
    if (are_single) {
      writer.number(static_cast<float>(x));
    } else {
      writer.number(x);
    }
  }
}

/// All but the values. \param is_of_faces whether faces have them, not wedges
void write_attribute(ByteWriter& writer, const Attribute& attribute, bool is_of_faces) {
  writer.count(1);
  writer.number(static_cast<std::uint8_t>((is_of_faces ? 1 : 0) + (attribute.is_normalized ? 2 : 0)));
  writer.number(static_cast<std::uint8_t>(attribute.kind));
  writer.number(static_cast<std::uint8_t>(attribute.type));
  writer.count(attribute.n_components);
  write_text(writer, attribute.name);
}

void write_contractions(ByteWriter& writer, std::span<const Contraction> contractions) {
  constexpr std::size_t bytes_each = 40;
  writer.bytes().reserve(contractions.size() * bytes_each);
  for (const Contraction& contraction : contractions) {
    const std::uint64_t kind = (contraction.is_threshold_pair ? 1U : 0U) | (contraction.joins_faces ? 2U : 0U);
    writer.count((std::uint64_t{contraction.removed} << 2) | kind);
    writer.difference(difference(contraction.survivor, contraction.removed));
  }
  for (const Contraction& contraction : contractions) write_position(writer, contraction.position);
  for (const Contraction& contraction : contractions) writer.number(contraction.cost);
}

void write_moved(ByteWriter& writer, std::span<const PassEnd::MovedVertex> moved) {
  Index last = 0;
  for (const auto& [vertex, position] : moved) {
    writer.difference(difference(vertex, last));
    last = vertex;
  }
  for (const auto& [vertex, position] : moved) write_position(writer, position);
}

void write_turned(ByteWriter& writer, std::span<const PassEnd::TurnedFace> turned) {
  Index last = 0;
  for (const auto& [face, corners] : turned) {
    writer.difference(difference(face, last));
    write_corners(writer, corners, 0);
    last = face;
  }
}

class ChunkList {
 public:
  void add(std::string_view type, std::function<void(ByteWriter&)> write_payload) {
    chunks_.push_back({type, std::move(write_payload)});
  }
  /// Writes elements in chunks. Each chunk begins with its number of elements.
  template <class Item, class Write>
  void add_elements(std::string_view type, std::span<const Item> items, const Write& write) {
    for (std::size_t begin = 0; begin < items.size(); begin += most_elements) {
      const auto part = items.subspan(begin, std::min(most_elements, items.size() - begin));
      add(type, [part, write](ByteWriter& writer) {
        writer.count(part.size());
        write(writer, part);
      });
    }
  }
  void write(std::ostream& out, const RecordingOptions& options) const;

 private:
  std::vector<ChunkToWrite> chunks_;
};

/// Some chunks at a time, so that there is memory for few of them.
void ChunkList::write(std::ostream& out, const RecordingOptions& options) const {
  constexpr std::size_t at_a_time = 64;
  for (std::size_t begin = 0; begin < chunks_.size(); begin += at_a_time) {
    std::vector<std::string> bytes(std::min(at_a_time, chunks_.size() - begin));
    for_each_block(bytes.size(), options.threads, [&](std::size_t i) {
      ByteWriter writer;
      chunks_[begin + i].write_payload(writer);
      bytes[i] = framed(chunks_[begin + i].type, writer.bytes(), options.compress);
    });
    for (const std::string& part : bytes) out << part;
  }
}

void add_attributes(const std::vector<Attribute>& attributes, bool are_of_faces, ChunkList& chunks) {
  for (const Attribute& attribute : attributes) {
    chunks.add("ATTR",
               [&attribute, are_of_faces](ByteWriter& writer) { write_attribute(writer, attribute, are_of_faces); });
    chunks.add_elements("VALU", std::span(attribute.values), write_values);
  }
}

void add_mesh(const IndexedMesh& mesh, ChunkList& chunks) {
  chunks.add_elements("VERT", std::span(mesh.positions), write_positions);
  chunks.add_elements("FACE", std::span(mesh.faces), write_faces);
  chunks.add_elements("NORM", std::span(mesh.normals), write_floats<3>);
  chunks.add_elements("COLR", std::span(mesh.colors), write_floats<4>);
  chunks.add_elements("ORIG", std::span(mesh.origins), write_indices);
  chunks.add_elements("WEDG", std::span(mesh.wedges), write_indices);
  add_attributes(mesh.attributes, false, chunks);
  add_attributes(mesh.face_attributes, true, chunks);
  chunks.add_elements("GRUP", std::span(mesh.face_groups), write_indices);
  for (const std::string& name : mesh.group_names) {
    chunks.add("NAME", [&name](ByteWriter& writer) {
      writer.count(1);
      write_text(writer, name);
    });
  }
}

/// The first texts that fit in one chunk; at least one. \pre none has more than `most_about` bytes
std::span<const std::string> texts_of_chunk(std::span<const std::string> texts) {
  std::size_t n = 0;
  for (std::size_t bytes = 0; n < std::min(most_elements, texts.size()) && bytes < most_about; ++n) {
    bytes += texts[n].size();
  }
  return texts.first(n);
}

void add_notes(const RecordingNotes& notes, ChunkList& chunks) {
  for (const auto& note : notes) {
    const std::string& name = note.first;
    for (std::span<const std::string> rest(note.second); !rest.empty();) {
      const auto part = texts_of_chunk(rest);
      rest = rest.subspan(part.size());
      chunks.add("note", [&name, part](ByteWriter& writer) {
        writer.count(part.size());
        write_text(writer, name);
        for (const std::string& text : part) write_text(writer, text);
      });
    }
  }
}

void add_steps(const RunSteps& steps, ChunkList& chunks) {
  const std::span contractions(steps.contractions);
  std::size_t n_done = 0;
  for (const PassEnd& end : steps.pass_ends) {
    chunks.add_elements("STEP", contractions.subspan(n_done, end.n_contractions - n_done), write_contractions);
    chunks.add("PASS", [](ByteWriter&) {});
    chunks.add_elements("MOVE", std::span(end.moved), write_moved);
    chunks.add_elements("TURN", std::span(end.turned), write_turned);
    n_done = end.n_contractions;
  }
  chunks.add_elements("STEP", contractions.subspan(n_done), write_contractions);
}

void write_head(ByteWriter& writer, const IndexedMesh& input, const RunSteps& steps, Normals normals,
                std::string_view about, bool is_embedded) {
  writer.count(input.positions.size());
  writer.count(input.faces.size());
  writer.count(steps.contractions.size());
  writer.count(steps.pass_ends.size());
  for (const std::uint64_t part : content_hash(input)) writer.number(part);
  writer.number(static_cast<std::uint8_t>(normals));
  writer.number(static_cast<std::uint8_t>((is_embedded ? 1 : 0) + (steps.fits_attributes ? 2 : 0)));
  writer.count(about.size());
  writer.text(about);
}

/// \throw std::invalid_argument
void check_texts(const IndexedMesh& mesh, const RecordingNotes& notes) {
  const auto require_short = [](const std::string& text) {
    if (text.size() > most_about) throw std::invalid_argument("recording: a text of more than a million bytes");
  };
  for (const Attribute& attribute : mesh.attributes) require_short(attribute.name);
  for (const Attribute& attribute : mesh.face_attributes) require_short(attribute.name);
  for (const std::string& name : mesh.group_names) require_short(name);
  for (const auto& [name, texts] : notes) {
    require_short(name);
    for (const std::string& text : texts) require_short(text);
  }
}

}  // namespace

void write_recording(std::ostream& out, const IndexedMesh& input, const RunSteps& steps, Normals normals,
                     std::string_view about, const RecordingOptions& options) {
  if (about.size() > most_about) throw std::invalid_argument("recording: more than a million bytes of text about it");
  check_texts(input, options.notes);
  ChunkList chunks;
  chunks.add("HEAD", [&](ByteWriter& writer) { write_head(writer, input, steps, normals, about, options.embed); });
  if (options.embed) add_mesh(input, chunks);
  add_notes(options.notes, chunks);
  if (steps.crease_angle_deg < 180) {
    chunks.add("CREA", [&](ByteWriter& writer) { writer.number(steps.crease_angle_deg); });
  }
  add_steps(steps, chunks);
  chunks.add("END ", [](ByteWriter&) {});
  write_signature(out);
  chunks.write(out, options);
}

}  // namespace whittle::progressive
