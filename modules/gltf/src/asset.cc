#include "whittle/gltf/asset.hh"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "asset_content.hh"
#include "codec/meshopt.hh"
#include "document/glb.hh"
#include "document/json.hh"
#include "document/uri.hh"
#include "geometry/elements.hh"
#include "geometry/instances.hh"
#include "geometry/read_triangles.hh"
#include "geometry/split.hh"
#include "geometry/surface.hh"
#include "model/extensions.hh"
#include "model/read_materials.hh"
#include "model/read_model.hh"
#include "whittle/io/output_file.hh"
#include "whittle/io/whole_file.hh"
#include "write/level_nodes.hh"
#include "write/merge.hh"
#include "write/output.hh"
#include "write/quantization.hh"
#include "write/references.hh"
#include "write/share_buffer.hh"

namespace whittle::gltf {

Output Asset::Content::output(const Replacements& replaced, const WriteOptions& options) const {
  const bool compress = options.compress && !replaced.empty();
  if (compress && !has_meshopt()) throw std::invalid_argument("this build can't compress: it has no meshoptimizer");
  return make_output(model, document, options.merge ? merged(document, model, replaced) : replaced, options);
}

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

std::string utf8(const std::filesystem::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}

bool is_in_document(const Model& model) {
  const auto first =
      std::find_if(model.buffers.begin(), model.buffers.end(), [](const Buffer& buffer) { return buffer.bytes; });
  return first != model.buffers.end() && first->is_in_document;
}

/// Whether it is the material of a surface that `make_asset` knows nothing of.
bool is_plain(Json material) {
  if (!material.is_object()) return false;
  material.erase("name");
  material.erase("alphaMode");
  material.erase("doubleSided");
  const Json white = {{"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
  return material == Json{{"pbrMetallicRoughness", white}};
}

/// The files that the elements of a list name, each once.
std::vector<std::filesystem::path> files_of(const Json& document, const char* list) {
  std::vector<std::filesystem::path> files;
  std::set<std::filesystem::path> seen;
  for (const Json& element : elements_of(document, list)) {
    const Json* const uri = member(element, "uri");
    if (!uri || !uri->is_string() || is_data_uri(uri->get_ref<const std::string&>())) continue;
    auto file = file_of_uri(uri->get_ref<const std::string&>());
    if (file && seen.insert(file->lexically_normal()).second) files.push_back(*std::move(file));
  }
  return files;
}

/// Copies of images, except existing ones.
std::vector<AssetFile> copies_of(const std::vector<std::filesystem::path>& images, const std::filesystem::path& from,
                                 const std::filesystem::path& to) {
  std::vector<AssetFile> copies;
  std::error_code error;
  if (from.empty() || std::filesystem::equivalent(from, to, error)) return copies;
  for (const std::filesystem::path& image : images) {
    const std::filesystem::path copy = to / image;
    const bool is_inside = std::none_of(image.begin(), image.end(), [](const auto& part) { return part == ".."; });
    if (!is_inside || std::filesystem::exists(copy, error)) continue;
    if (!std::filesystem::is_regular_file(from / image, error)) continue;
    copies.push_back({copy, io::read_file(from / image, (from / image).string())});
  }
  return copies;
}

/// Whether an object of JSON may begin there: after white space and a mark of UTF-8.
bool may_be_json(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

bool are_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error);
}

/// Where a buffer of a text file goes: beside it, but not in place of a buffer of the input, which others may need.
std::filesystem::path free_buffer_path(std::filesystem::path path, const std::filesystem::path& output,
                                       const Json& document, const std::filesystem::path& source) {
  if (source.empty() || are_same_file(output, source)) return path;
  for (const Json& buffer : elements_of(document, "buffers")) {
    const Json* const uri = member(buffer, "uri");
    const auto file = uri && uri->is_string() ? file_of_uri(uri->get_ref<const std::string&>()) : std::nullopt;
    if (file && are_same_file(source.parent_path() / *file, path)) {
      path.replace_filename(path.stem().string() + "_simplified.bin");
    }
  }
  return path;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

bool is_glb(std::string_view bytes) { return bytes.starts_with(glb_magic); }

Asset::Asset(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Asset::Asset(Asset&& other) noexcept = default;
Asset& Asset::operator=(Asset&& other) noexcept = default;
Asset::~Asset() = default;

Asset Asset::read(const std::filesystem::path& path) {
  Asset asset = read(io::read_file(path, path.string()), path.string(), folder_of(path));
  asset.content_->source = path;
  return asset;
}

Asset Asset::read(std::string bytes, const std::string& name, const std::filesystem::path& folder) {
  auto content = std::make_unique<Content>();
  content->bytes = std::move(bytes);
  content->folder = folder;
  if (content->bytes.empty()) throw io::ReadError(name, "the file is empty");
  GlbParts parts{content->bytes, {}};
  if (is_glb(content->bytes)) {
    parts = split_glb(content->bytes, name);
  } else if (!may_be_json(content->bytes)) {
    throw io::ReadError(name, "is no glTF: it begins neither with \"glTF\", as a GLB does, nor with \"{\"");
  }
  content->document = parse_json(parts.json, name);
  content->read_document(name);
  return Asset(std::move(content));
}

void Asset::Content::read_document(const std::string& name) {
  const auto chunk = is_glb(bytes) ? split_glb(bytes, name).buffer : std::nullopt;
  model = read_model(document, {name, chunk, folder});
  rest = read_rest(model, Part(document, "", name));
}

std::size_t Asset::n_meshes() const { return content_->model.meshes.size(); }

std::string Asset::mesh_name(std::size_t mesh) const {
  const Json* const name = member(elements_of(content_->document, "meshes").at(mesh), "name");
  if (!name || !name->is_string() || name->get_ref<const std::string&>().empty()) return "mesh " + std::to_string(mesh);
  return printable(name->get_ref<const std::string&>());
}

std::size_t Asset::n_triangles(std::size_t mesh) const {
  const auto found = content_->replacements.find(mesh);
  if (found != content_->replacements.end()) return found->second.faces.size();
  std::size_t n = 0;
  for (const Primitive& primitive : content_->mesh(mesh).primitives) n += n_triangles_of(content_->model, primitive);
  return n;
}

std::size_t Asset::n_instances(std::size_t mesh) const { return gltf::n_instances(content_->model, mesh); }

bool Asset::is_level(std::size_t mesh) const {
  bool is_level = false;
  for (const Node& node : content_->model.nodes) {
    if (node.mesh != mesh) continue;
    if (node.is_shown) return false;
    is_level = is_level || node.is_level;
  }
  return is_level;
}

std::vector<Eigen::Matrix4d> Asset::world_transforms(std::size_t mesh) const {
  return gltf::world_transforms(content_->model, content_->rest, mesh);
}

IndexedMesh Asset::triangles(std::size_t mesh) const {
  const auto found = content_->replacements.find(mesh);
  if (found != content_->replacements.end()) return found->second;
  if (mesh >= n_meshes()) throw std::out_of_range("there is no mesh " + std::to_string(mesh));
  return read_triangles(content_->model, content_->document, mesh);
}

void Asset::set_triangles(std::size_t mesh, IndexedMesh triangles) {
  if (mesh >= n_meshes()) throw std::out_of_range("there is no mesh " + std::to_string(mesh));
  check_replacement(content_->model, mesh, triangles);
  content_->replacements.insert_or_assign(mesh, std::move(triangles));
}

bool Asset::has_levels(std::size_t mesh) const { return gltf::has_levels(content_->document, mesh); }

namespace {

void check_levels(const Asset& asset, const Model& model, const MeshLevels& levels) {
  if (levels.mesh >= asset.n_meshes()) throw std::out_of_range("there is no mesh " + std::to_string(levels.mesh));
  if (asset.has_levels(levels.mesh)) {
    throw std::invalid_argument(asset.mesh_name(levels.mesh) + " has levels of detail already");
  }
  if (levels.screen_coverage.size() != levels.coarser.size() + 1) {
    throw std::invalid_argument("levels of detail: there have to be as many shares of the screen as levels");
  }
  for (const IndexedMesh& level : levels.coarser) check_replacement(model, levels.mesh, level);
}

}  // namespace

void Asset::add_levels(std::vector<MeshLevels> levels) {
  std::set<std::size_t> meshes;
  for (const MeshLevels& mesh : levels) {
    check_levels(*this, content_->model, mesh);
    if (!meshes.insert(mesh.mesh).second) throw std::invalid_argument("levels of detail: a mesh stands there twice");
  }
  std::vector<std::vector<std::size_t>> copies;
  for (const MeshLevels& mesh : levels) {
    std::vector<std::size_t>& of_mesh = copies.emplace_back();
    for (std::size_t level = 1; level <= mesh.coarser.size(); ++level) {
      of_mesh.push_back(add_mesh_copy(content_->document, mesh.mesh, level));
    }
    add_level_nodes(content_->document, mesh.mesh, of_mesh, mesh.screen_coverage);
  }
  content_->read_document(std::string(content_->model.file));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t k = 0; k < copies[i].size(); ++k) set_triangles(copies[i][k], std::move(levels[i].coarser[k]));
  }
}

bool Asset::has_look(std::size_t mesh, std::size_t primitive) const {
  const std::optional<std::size_t> material = content_->mesh(mesh).primitives.at(primitive).material;
  const Json& materials = elements_of(content_->document, "materials");
  return material && *material < materials.size() && !is_plain(materials[*material]);
}

std::vector<std::string> Asset::other_content() const {
  std::vector<std::string> content;
  const auto has_mode = [this](PrimitiveMode first, PrimitiveMode last) {
    return std::any_of(content_->model.meshes.begin(), content_->model.meshes.end(), [&](const Mesh& mesh) {
      return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                         [&](const Primitive& one) { return one.mode >= first && one.mode <= last; });
    });
  };
  if (has_mode(PrimitiveMode::lines, PrimitiveMode::line_strip)) content.emplace_back("lines");
  if (has_mode(PrimitiveMode::points, PrimitiveMode::points)) content.emplace_back("points");
  for (const char* const list : {"animations", "skins", "cameras"}) {
    if (!elements_of(content_->document, list).empty()) content.emplace_back(list);
  }
  const Json* const extensions = member(content_->document, "extensions");
  const Json* const lights = extensions ? member(*extensions, "KHR_lights_punctual") : nullptr;
  if (lights && !elements_of(*lights, "lights").empty()) content.emplace_back("lights");
  return content;
}

std::vector<std::vector<Material>> Asset::materials() const {
  const Source source{content_->model.file, {}, content_->folder};
  MaterialReader reader(content_->model, content_->document, source);
  std::vector<std::vector<Material>> materials(n_meshes());
  for (std::size_t mesh = 0; mesh < n_meshes(); ++mesh) {
    if (n_triangles(mesh) == 0) continue;
    const std::vector<std::string> names = material_names(content_->model, content_->document, mesh);
    for (const Primitive& primitive : content_->mesh(mesh).primitives) {
      Material& material = materials[mesh].emplace_back();
      if (primitive.material) material = reader.read(*primitive.material);
      material.name = names[materials[mesh].size() - 1];
    }
  }
  return materials;
}

std::vector<std::string> Asset::warnings(const WriteOptions& options) const {
  std::vector<std::string> warnings;
  for (const auto& [mesh, triangles] : content_->replacements) {
    const std::set<std::string> extensions = extensions_in(content_->document["meshes"][mesh]);
    for (const std::string_view name : {outline_extension, manifold_extension}) {
      if (!extensions.contains(std::string(name))) continue;
      warnings.push_back(mesh_name(mesh) + ": dropped " + std::string(name) + ", which is about single vertices");
    }
  }
  if (!options.quantize) return warnings;
  const Content& content = *content_;
  const Quantization quantization = quantization_of(
      content.document, content.model,
      options.merge ? merged(content.document, content.model, content.replacements) : content.replacements);
  for (const auto& [mesh, why] : quantization.kept) {
    warnings.push_back(mesh_name(mesh) + ": its positions stay real numbers, as " + why);
  }
  return warnings;
}

std::vector<std::filesystem::path> Asset::image_files() const { return files_of(content_->document, "images"); }

std::vector<std::filesystem::path> Asset::buffer_files() const { return files_of(content_->document, "buffers"); }

std::string Asset::document() const { return content_->document.dump(); }

std::string Asset::write_glb(const WriteOptions& options) const {
  const Output output = content_->output(content_->replacements, options);
  return join_glb(output.document.dump(), output.buffer);
}

Asset Asset::as_written(std::map<std::size_t, IndexedMesh> triangles, const WriteOptions& options) const {
  for (const auto& [mesh, own] : triangles) check_replacement(content_->model, mesh, own);
  triangles.insert(content_->replacements.begin(), content_->replacements.end());
  const Output output = content_->output(triangles, options);
  return read(join_glb(output.document.dump(), output.buffer), content_->model.file);
}

GltfText Asset::write_gltf(const std::string& buffer_uri, const WriteOptions& options) const {
  Output output = content_->output(content_->replacements, options);
  GltfText text;
  const bool shares = !options.shared_buffer.empty();
  if (shares) text.shared = take_shared_buffer(output, uri_of_file(utf8(options.shared_buffer.filename())));
  if (!output.buffer.empty()) {
    Json& first = output.document["buffers"][0];
    if (is_in_document(content_->model) && !shares) {
      first["uri"] = data_uri(output.buffer);
    } else {
      text.buffer_uri = buffer_uri;
      first["uri"] = buffer_uri;
      text.buffer = std::move(output.buffer);
    }
  }
  constexpr int indentation = 2;
  text.json = output.document.dump(indentation) + '\n';
  return text;
}

std::vector<AssetFile> Asset::files(const std::filesystem::path& path, const WriteOptions& options) const {
  std::vector<AssetFile> files;
  if (lower_case(path.extension().string()) == ".gltf") {
    const auto beside = [&](const std::filesystem::path& buffer) {
      return free_buffer_path(buffer, path, content_->document, content_->source);
    };
    const std::filesystem::path buffer_path = beside(std::filesystem::path(path).replace_extension(".bin"));
    WriteOptions here = options;
    if (!here.shared_buffer.empty()) here.shared_buffer = beside(here.shared_buffer);
    GltfText text = write_gltf(uri_of_file(utf8(buffer_path.filename())), here);
    files.push_back({path, std::move(text.json)});
    if (!text.buffer.empty()) files.push_back({buffer_path, std::move(text.buffer)});
    if (!text.shared.empty()) files.push_back({here.shared_buffer, std::move(text.shared)});
  } else {
    files.push_back({path, write_glb(options)});
  }
  for (AssetFile& copy : copies_of(image_files(), content_->folder, folder_of(path))) files.push_back(std::move(copy));
  return files;
}

void Asset::write(const std::filesystem::path& path, const WriteOptions& options) const {
  std::vector<std::unique_ptr<io::OutputFile>> written;
  for (const AssetFile& file : files(path, options)) {
    std::error_code error;
    if (file.path != path) std::filesystem::create_directories(folder_of(file.path), error);
    written.push_back(std::make_unique<io::OutputFile>(file.path));
    written.back()->stream().write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  }
  for (const auto& file : written) file->commit();
}

}  // namespace whittle::gltf
