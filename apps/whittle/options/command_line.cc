#include "options/command_line.hh"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "options/help.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<ColorMode>, 3> color_modes{
    {{"auto", ColorMode::automatic}, {"always", ColorMode::always}, {"never", ColorMode::never}}};

/// "obj|off|ply": the extensions of formats. \param has_documents whether documents are included
std::string extensions(std::string_view separator, bool has_documents) {
  std::string text;
  for (const SceneFormat* format : scene_formats()) {
    for (const std::string_view extension : format->extensions) {
      if (!has_documents && format->is_document) continue;
      text += (text.empty() ? "" : std::string(separator)) + std::string(extension);
    }
  }
  return text;
}

/// \param takes_documents whether the format may be that of a document
const SceneFormat* parse_format(std::string_view text, bool takes_documents) {
  const SceneFormat* const format = format_by_extension(text);
  if (format != nullptr && (takes_documents || !format->is_document)) return format;
  throw std::invalid_argument("'" + std::string(text) + "' is none of " + extensions("|", takes_documents));
}

const SceneFormat* parse_input_format(std::string_view text, const FileOptions& options) {
  const SceneFormat* const format = format_by_extension(text);
  if (format != nullptr && format->is_document && !options.reads_documents) {
    throw std::invalid_argument("'" + std::string(text) + "' is none of " + extensions("|", false) +
                                "; this command doesn't read " + std::string(format->title) +
                                ", 'whittle convert' does");
  }
  return parse_format(text, options.reads_documents);
}

OptionValue told(const SceneFormat* format) {
  return format != nullptr ? OptionValue(std::string(format->name)) : OptionValue{};
}

OptionAccess format_access(const SceneFormat*& format) {
  return {"EXT", [&format](std::string_view text) { format = parse_format(text, false); },
          [&format] { return app::told(format); }};
}

OptionAccess input_format_access(FileOptions& options) {
  const std::string others = extensions("|", false);
  const std::string meta = options.reads_documents ? "EXT" + extensions("|", true).substr(others.size()) : "EXT";
  return {meta, [&options](std::string_view text) { options.input_format = parse_input_format(text, options); },
          [&options] { return app::told(options.input_format); }};
}

std::string mesh_file(const FileOptions& options) {
  const std::string gltf = options.reads_documents ? ", glTF" : "";
  return "the mesh: an " + io::format_titles() + " file" + gltf + ", or '-' for standard input";
}

}  // namespace

OptionRows common_rows(CommonOptions& options) {
  return in_group(
      {{.names = "--json",
        .access = text(options.json, "FILE|-"),
        .help = "write the report as JSON to FILE, or to standard output"},
       {.names = "-q,--quiet",
        .access = flag(options.quiet),
        .help = "say nothing but errors on standard error",
        .conflicts = {{"", "--verbose", "say less or say more"}}},
       {.names = "-v,--verbose", .access = flag(options.verbose), .help = "say more on standard error"},
       {.names = "--force",
        .access = flag(options.force),
        .help = "let an output file replace an input file, or one that is write-protected"},
       {.names = "--threads",
        .access = count(options.threads, 0, 1024),
        .help = "threads to work with, 0 <= N <= 1024; 0 takes all cores; no result depends on it",
        .key = "threads"},
       {.names = "--color",
        .access = choice(options.color, color_modes),
        .help = "colour on standard error: on a terminal, unless NO_COLOR is set (auto), always, or never"}},
      common_group);
}

ColorMode color_of(const CLI::App& app) {
  ColorMode mode = ColorMode::automatic;
  for (const CLI::App* called : app.get_subcommands()) {
    const CLI::Option* option = called->get_option_no_throw("--color");
    if (option == nullptr || option->count() == 0) continue;
    for (const Choice<ColorMode>& choice : color_modes) {
      if (choice.word == option->results().front()) mode = choice.value;
    }
  }
  return mode;
}

OptionRows input_format_rows(FileOptions& options) {
  return {{.names = "--format",
           .access = format_access(options.format),
           .help = "the format, such as ply, of '-' and of files whose name doesn't tell it",
           .standard = "by name"},
          {.names = "--input-format",
           .access = input_format_access(options),
           .help = "the format to read, whatever a file's name says",
           .standard = "by name"}};
}

OptionRow weld_row(FileOptions& options) {
  return {.names = "--weld",
          .access = automatic_length(options.weld_tolerance),
          .help =
              "weld vertices on open borders that lie within T of each other: model units, a percentage of the "
              "diagonal, or 'auto' to choose T from the gaps between borders (0: exact duplicates alone)",
          .key = "weld_tolerance",
          .conflicts = {{"", "--no-weld", "vertices are welded or they are not"}}};
}

OptionRows input_rows(FileOptions& options) {
  OptionRows rows = input_format_rows(options);
  rows.push_back(weld_row(options));
  rows.push_back({.names = "--no-weld",
                  .access = flag(options.weld, false),
                  .help = "keep exact duplicates of vertices apart instead of making them one",
                  .key = "weld",
                  .reported = [&options] { return OptionValue(options.weld); }});
  return rows;
}

OptionRows file_rows(FileOptions& options) {
  OptionRows rows = input_rows(options);
  append(rows, {{.names = "--output-format",
                 .access = format_access(options.output_format),
                 .help = "the format to write, whatever the name of OUT says",
                 .standard = "by name"},
                {.names = "--ascii",
                 .access = flag(options.ascii),
                 .help = "write text instead of binary data: " + io::titles_with_text_and_binary(),
                 .key = "ascii"}});
  return rows;
}

OptionRows gltf_rows(gltf::WriteOptions& options) {
  return {{.names = "--compress",
           .access = flag(options.compress),
           .help = "compress the geometry of a glTF file: rounded, and by EXT_meshopt_compression",
           .key = "compress"},
          {.names = "--quantize",
           .access = flag(options.quantize),
           .help = "write the geometry of a glTF file as integers of 8 and 16 bits: KHR_mesh_quantization",
           .key = "quantize"},
          {.names = "--merge-meshes",
           .access = flag(options.merge),
           .help = "make one primitive of those with one material, also of meshes that stand still in a glTF scene",
           .key = "merge_meshes"}};
}

OptionRow side_file_row(const std::string& name, std::optional<std::string>& path, const std::string& what) {
  return {.names = name, .access = text(path, "FILE"), .help = what};
}

OptionRow output_row(std::string& path, const std::string& meaning) {
  return {.names = "-o,--output", .access = text(path, "OUT"), .help = meaning, .is_required = true};
}

OptionRow file_argument(const std::string& name, std::string& path, const std::string& meaning) {
  return {.names = name, .access = text(path, ""), .help = meaning, .is_required = true};
}

OptionRow mesh_argument(std::string& path, const FileOptions& options) {
  return file_argument("IN", path, mesh_file(options));
}

OptionRow meshes_argument(std::vector<std::string>& paths, const FileOptions& options, const std::string& several) {
  return {.names = "IN",
          .access = texts(paths),
          .help = mesh_file(options) + "; " + several,
          .is_required = true,
          .takes_several = true};
}

OptionRows in_group(OptionRows rows, const std::string& group) {
  for (OptionRow& row : rows) row.group = group;
  return rows;
}

}  // namespace whittle::app
