#include "write/pack_buffers.hh"

#include <algorithm>
#include <vector>

#include "model/extensions.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

constexpr std::size_t alignment = 8;

/// A range of bytes, and the object of the document that says so.
struct PackedRange {
  Json* object;
  std::size_t buffer;
  std::size_t offset;
  std::size_t length;
};

/// Ranges in the order of buffers and offsets, without ranges outside of a buffer.
std::vector<PackedRange> ranges_of(Json& document, const Model& model) {
  std::vector<PackedRange> ranges;
  for_each_range(document, [&](Json& object) {
    const Json* const offset = member(object, "byteOffset");
    const PackedRange range{&object, *as_whole(object["buffer"]), offset ? as_whole(*offset).value_or(0) : 0,
                            *as_whole(object["byteLength"])};
    if (range.buffer >= model.buffers.size()) return;
    const std::size_t size = model.buffers[range.buffer].size;
    if (range.offset <= size && range.length <= size - range.offset) ranges.push_back(range);
  });
  std::stable_sort(ranges.begin(), ranges.end(), [](const PackedRange& a, const PackedRange& b) {
    return std::pair(a.buffer, a.offset) < std::pair(b.buffer, b.offset);
  });
  return ranges;
}

/// The next offset from `at` on that equals `like` modulo 8.
std::size_t aligned(std::size_t at, std::size_t like) {
  return at + (like % alignment + alignment - at % alignment) % alignment;
}

void move_range(Json& object, std::size_t buffer, std::size_t offset) {
  object["buffer"] = buffer;
  if (offset != 0 || member(object, "byteOffset")) object["byteOffset"] = offset;
}

/// Puts ranges that overlap, or touch each other, where they are one run of bytes again.
class Packer {
 public:
  Packer(const Model& model, PackedBuffers& to) : model_(model), to_(to) {}

  void add(const PackedRange& range) {
    if (run_buffer_ != range.buffer || range.offset > run_end_ || !has_run_) begin_run(range);
    extend_run(range.offset + range.length);
    const bool has_bytes = model_.buffers[range.buffer].bytes.has_value();
    move_range(*range.object, has_bytes ? first_buffer : fallback_buffer, run_to_ + (range.offset - run_begin_));
  }

 private:
  void begin_run(const PackedRange& range) {
    has_run_ = true;
    run_buffer_ = range.buffer;
    run_begin_ = run_end_ = range.offset;
    const bool has_bytes = model_.buffers[range.buffer].bytes.has_value();
    run_to_ = aligned(has_bytes ? to_.bytes.size() : to_.n_fallback_bytes, range.offset);
    if (has_bytes) {
      to_.bytes.resize(run_to_);
    } else {
      to_.n_fallback_bytes = run_to_;
    }
  }

  void extend_run(std::size_t end) {
    if (end <= run_end_) return;
    const Buffer& buffer = model_.buffers[run_buffer_];
    if (buffer.bytes) {
      to_.bytes += buffer.bytes->substr(run_end_, end - run_end_);
    } else {
      to_.n_fallback_bytes += end - run_end_;
    }
    run_end_ = end;
  }

  const Model& model_;
  PackedBuffers& to_;
  bool has_run_ = false;
  std::size_t run_buffer_ = 0;
  std::size_t run_begin_ = 0;  // in the input's buffer
  std::size_t run_end_ = 0;
  std::size_t run_to_ = 0;  // where its beginning is now
};

/// The input's description of its first buffer with bytes, without the members that are written anew.
Json description_of_first(const Json& document, const Model& model) {
  const Json& buffers = elements_of(document, "buffers");
  for (std::size_t i = 0; i < model.buffers.size(); ++i) {
    if (!model.buffers[i].bytes) continue;
    Json buffer = buffers[i];
    buffer.erase("uri");
    if (const Json* extensions = member(buffer, "extensions"); extensions && member(*extensions, meshopt_extension)) {
      buffer.erase("extensions");
    }
    return buffer;
  }
  return Json::object();
}

}  // namespace

PackedBuffers pack_buffers(Json& document, const Model& model) {
  PackedBuffers packed;
  Packer packer(model, packed);
  for (const PackedRange& range : ranges_of(document, model)) packer.add(range);
  return packed;
}

void list_buffers(Json& document, const Model& model, const PackedBuffers& packed) {
  Json buffers = Json::array();
  if (!packed.bytes.empty()) {
    Json buffer = description_of_first(document, model);
    buffer["byteLength"] = packed.bytes.size();
    buffers.push_back(std::move(buffer));
  }
  if (packed.n_fallback_bytes > 0) {
    buffers.push_back({{"byteLength", packed.n_fallback_bytes},
                       {"extensions", {{std::string(meshopt_extension), {{"fallback", true}}}}}});
  }
  if (!buffers.empty()) {
    document["buffers"] = std::move(buffers);
  } else if (document.is_object()) {
    document.erase("buffers");
  }
}

}  // namespace whittle::gltf
