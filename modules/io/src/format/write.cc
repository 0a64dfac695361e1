#include "whittle/io/write.hh"

#include <ostream>
#include <stdexcept>

#include "format/format_row.hh"
#include "whittle/io/output_file.hh"

namespace whittle::io {

namespace {

WriteResult format_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options,
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

}  // namespace

WriteResult write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options) {
  const Format format = options.format ? *options.format : format_of(path);
  OutputFile file(path);
  WriteResult result = format_mesh(file.stream(), format, mesh, options, path.string());
  file.commit();
  return result;
}

WriteResult write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options) {
  WriteResult result = format_mesh(out, format, mesh, options, "output");
  if (!out) throw WriteError("output", "writing failed");
  return result;
}

}  // namespace whittle::io
