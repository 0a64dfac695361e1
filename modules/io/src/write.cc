#include "whittle/io/write.hh"

#include <ostream>
#include <stdexcept>

#include "whittle/io/output_file.hh"
#include "writers.hh"

namespace whittle::io {

namespace {

WriteResult format_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options,
                        const std::string& name) {
  WriteResult result;
  ByteSink sink(out);
  try {
    switch (format) {
      case Format::obj:
        write_obj(sink, mesh, result.warnings);
        break;
      case Format::off:
        write_off(sink, mesh, options);
        break;
      case Format::ply:
        write_ply(sink, mesh, options);
        break;
      case Format::stl:
        write_stl(sink, mesh, options, result.warnings);
        break;
    }
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
