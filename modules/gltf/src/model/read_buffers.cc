#include <algorithm>
#include <system_error>

#include "codec/meshopt.hh"
#include "document/uri.hh"
#include "model/extensions.hh"
#include "model/read_model.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::gltf {
namespace {

constexpr std::size_t least_stride = 4;
constexpr std::size_t most_stride = 252;

Buffer read_buffer(Model& model, const Part& part, const Source& source, bool is_first) {
  Buffer buffer;
  buffer.size = part.required_whole("byteLength");
  const std::optional<std::string> uri = part.text("uri");
  if (uri) {
    model.decoded.push_back(bytes_of_uri(part, *uri, source));
    buffer.bytes = model.decoded.back();
    buffer.is_in_document = is_data_uri(*uri);
  } else if (is_first && source.chunk) {
    buffer.bytes = source.chunk;
  }
  if (!buffer.bytes) return buffer;
  if (buffer.bytes->size() < buffer.size) {
    part.fail("it should have " + std::to_string(buffer.size) + " bytes, and has " +
              std::to_string(buffer.bytes->size()));
  }
  buffer.bytes = buffer.bytes->substr(0, buffer.size);
  model.n_bytes += buffer.size;
  return buffer;
}

/// A part of a buffer, by the members that views and the compression of views have in common.
struct Range {
  std::size_t buffer;
  std::size_t offset;
  std::size_t length;
};

Range read_range(const Part& part, const std::vector<Buffer>& buffers) {
  const Range range{part.required_index("buffer", buffers.size(), "buffer"), part.whole_or("byteOffset", 0),
                    part.required_whole("byteLength")};
  const std::size_t size = buffers[range.buffer].size;
  if (range.offset > size || range.length > size - range.offset) {
    part.fail("it ends after the " + std::to_string(size) + " bytes of buffer " + std::to_string(range.buffer));
  }
  return range;
}

std::optional<std::string_view> bytes_of(const Range& range, const std::vector<Buffer>& buffers) {
  const Buffer& buffer = buffers[range.buffer];
  if (!buffer.bytes) return {};
  return buffer.bytes->substr(range.offset, range.length);
}

MeshoptLayout read_layout(const Part& part) {
  MeshoptLayout layout;
  layout.count = part.required_whole("count");
  layout.stride = part.required_whole("byteStride");
  const std::string mode = part.required_text("mode");
  const std::string filter = part.text("filter").value_or("NONE");
  const auto known_mode = meshopt_mode(mode);
  const auto known_filter = meshopt_filter(filter);
  if (!known_mode) part.fail("the mode " + printable(mode) + " is not known");
  if (!known_filter) part.fail("the filter " + printable(filter) + " is not known");
  layout.mode = *known_mode;
  layout.filter = *known_filter;
  return layout;
}

/// The decompressed bytes of a view.
std::string decompressed(const Model& model, const Part& part, std::size_t view_length) {
  const MeshoptLayout layout = read_layout(part);
  const std::optional<std::string_view> packed = bytes_of(read_range(part, model.buffers), model.buffers);
  if (!packed) part.fail("its buffer has no data");
  const std::string problem = problem_of(layout, packed->size());
  if (!problem.empty()) part.fail(problem);
  if (layout.count * layout.stride < view_length) part.fail("it has fewer bytes than the buffer view");
  std::optional<std::string> bytes = decode_meshopt(layout, *packed);
  if (!bytes) part.fail("the compressed data are damaged");
  return *std::move(bytes);
}

BufferView read_view(Model& model, const Part& part) {
  BufferView view;
  view.stride = part.whole("byteStride");
  if (view.stride && (*view.stride < least_stride || *view.stride > most_stride)) {
    part.fail("\"byteStride\" is " + std::to_string(*view.stride) + ", not from 4 to 252");
  }
  const Range range = read_range(part, model.buffers);
  const std::optional<std::string_view> bytes = bytes_of(range, model.buffers);
  const std::optional<Part> compression = part.extension(meshopt_extension);
  if (compression && has_meshopt()) {
    model.decoded.push_back(decompressed(model, *compression, range.length));
    view.bytes = model.decoded.back();
    model.n_bytes += view.bytes.size();
    return view;
  }
  if (!bytes && compression) part.fail("it is compressed, and this build can't read that: it has no meshoptimizer");
  if (!bytes) part.fail("buffer " + std::to_string(range.buffer) + " has no data");
  view.bytes = *bytes;
  return view;
}

/// The bytes of a view, from an offset on, for values of which each begins `stride` bytes after the one before.
std::string_view values_in(const Part& part, const Model& model, std::size_t view, std::size_t count,
                           std::size_t stride, std::size_t n_bytes) {
  const std::string_view bytes = model.views[view].bytes;
  const std::size_t offset = part.whole_or("byteOffset", 0);
  if (count == 0) return {};
  const bool fits = offset <= bytes.size() && n_bytes <= bytes.size() - offset &&
                    count - 1 <= (bytes.size() - offset - n_bytes) / stride;
  if (!fits) {
    part.fail("its " + std::to_string(count) + " values end after the " + std::to_string(bytes.size()) +
              " bytes of buffer view " + std::to_string(view));
  }
  return bytes.substr(offset, (count - 1) * stride + n_bytes);
}

ScalarType read_scalar_type(const Part& part) {
  const std::size_t number = part.required_whole("componentType");
  const std::optional<ScalarType> type = scalar_type(number);
  if (!type) part.fail("the component type " + std::to_string(number) + " is not known");
  return *type;
}

SparseValues read_sparse(const Model& model, const Part& part, const Accessor& accessor) {
  SparseValues sparse;
  sparse.count = part.required_whole("count");
  if (sparse.count > accessor.count) part.fail("it has more values than the accessor");
  const std::optional<Part> indices = part.object("indices");
  const std::optional<Part> values = part.object("values");
  if (!indices || !values) part.fail("\"indices\" or \"values\" are missing");
  sparse.index_type = read_scalar_type(*indices);
  if (!is_integer(sparse.index_type) || is_signed(sparse.index_type)) indices->fail("they are not of an unsigned type");
  const std::size_t n_views = model.views.size();
  const std::size_t index_size = size_of(sparse.index_type);
  sparse.indices = values_in(*indices, model, indices->required_index("bufferView", n_views, "buffer view"),
                             sparse.count, index_size, index_size);
  sparse.values = values_in(*values, model, values->required_index("bufferView", n_views, "buffer view"), sparse.count,
                            accessor.shape.packed_stride(accessor.type), accessor.shape.n_bytes(accessor.type));
  for (std::size_t k = 0; k < sparse.count; ++k) {
    const std::size_t index = load_whole(sparse.indices.data() + k * index_size, sparse.index_type);
    if (index >= accessor.count) {
      part.fail("index " + std::to_string(index) + " is above the " + std::to_string(accessor.count) + " values");
    }
  }
  return sparse;
}

Accessor read_accessor(const Model& model, const Part& part) {
  Accessor accessor;
  accessor.type = read_scalar_type(part);
  accessor.is_normalized = part.flag("normalized") && is_integer(accessor.type);
  const std::string shape = part.required_text("type");
  const std::optional<ElementShape> known_shape = element_shape(shape);
  if (!known_shape) part.fail("the type " + printable(shape) + " is not known");
  accessor.shape = *known_shape;
  accessor.count = part.required_whole("count");
  accessor.stride = accessor.shape.packed_stride(accessor.type);
  accessor.view = part.index("bufferView", model.views.size(), "buffer view");
  if (accessor.view) {
    accessor.stride = model.views[*accessor.view].stride.value_or(accessor.stride);
    accessor.bytes =
        values_in(part, model, *accessor.view, accessor.count, accessor.stride, accessor.shape.n_bytes(accessor.type));
  }
  if (const std::optional<Part> sparse = part.object("sparse")) {
    accessor.sparse = read_sparse(model, *sparse, accessor);
  }
  return accessor;
}

}  // namespace

std::string bytes_of_uri(const Part& part, const std::string& uri, const Source& source) {
  if (is_data_uri(uri)) {
    std::optional<std::string> bytes = decode_data_uri(uri);
    if (!bytes) part.fail("its data URI is no valid base64");
    return *std::move(bytes);
  }
  const std::optional<std::filesystem::path> path = file_of_uri(uri);
  if (!path) part.fail("\"" + printable(uri) + "\" is not a file beside the asset");
  if (source.folder.empty()) part.fail("its file \"" + printable(uri) + "\" is not there");
  std::error_code error;
  const std::filesystem::path file = source.folder / *path;
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) {
    part.fail("\"" + printable(uri) + "\" is not a file");  // a device may have no end
  }
  return io::read_file(file, source.file + ": " + part.name() + ": " + printable(uri));
}

void read_buffers(Model& model, const Part& root, const Source& source) {
  for (const Part& part : root.array("buffers", "buffer")) {
    model.buffers.push_back(read_buffer(model, part, source, model.buffers.empty()));
  }
}

void read_views(Model& model, const Part& root) {
  for (const Part& part : root.array("bufferViews", "buffer view")) model.views.push_back(read_view(model, part));
}

void read_accessors(Model& model, const Part& root) {
  for (const Part& part : root.array("accessors", "accessor")) model.accessors.push_back(read_accessor(model, part));
}

}  // namespace whittle::gltf
