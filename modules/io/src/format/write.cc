#include "whittle/io/write.hh"

#include <ostream>
#include <stdexcept>

#include "bytes/gzip.hh"
#include "format/format_row.hh"
#include "whittle/io/output_file.hh"

namespace whittle::io {

namespace {

WriteResult write_unpacked(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options,
                           const std::string& name) {
  WriteResult result;
  ByteSink sink(out);
  try {
    row_of(format).write(sink, mesh, options, result.warnings);
  } catch (const std::range_error& problem) {
    throw WriteError(name, problem.what());
  }
  sink.flush();
  return result;
}

WriteResult format_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options,
                        const std::string& name) {
  if (!options.gzip.value_or(false)) return write_unpacked(out, format, mesh, options, name);
  GzipBuffer packed(out);
  std::ostream stream(&packed);
  WriteResult result = write_unpacked(stream, format, mesh, options, name);
  packed.finish();
  return result;
}

}  // namespace

WriteResult write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options) {
  const Format format = options.format ? *options.format : format_of(path);
  WriteOptions by_name = options;
  by_name.gzip = options.gzip.value_or(has_gzip_extension(path));
  OutputFile file(path);
  WriteResult result = format_mesh(file.stream(), format, mesh, by_name, path.string());
  file.commit();
  return result;
}

WriteResult write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options) {
  WriteResult result = format_mesh(out, format, mesh, options, "output");
  if (!out) throw WriteError("output", "writing failed");
  return result;
}

}  // namespace whittle::io
