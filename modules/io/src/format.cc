#include "whittle/io/format.hh"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>

namespace whittle::io {

namespace {

struct KnownEnding {
  std::string_view ending;
  std::string_view what;
};

// Named rather than called unknown, because their owners expect a mesh tool to know them.
constexpr KnownEnding not_read[] = {
    {"glb", "glTF"},
    {"gltf", "glTF"},
    {"om", "OpenMesh's own format"},
    {"pm", "a progressive mesh"},
    {"3ds", "3D Studio"},
    {"max", "3ds Max"},
    {"fbx", "FBX"},
    {"dae", "Collada"},
    {"vtk", "VTK"},
    {"vtp", "VTK"},
    {"vtu", "VTK"},
    {"ctm", "OpenCTM"},
    {"3mf", "3MF"},
    {"amf", "AMF"},
    {"wrl", "VRML"},
    {"vrml", "VRML"},
    {"x3d", "X3D"},
    {"x3dv", "X3D"},
    {"blend", "a Blender scene"},
    {"ma", "Maya"},
    {"mb", "Maya"},
    {"lwo", "LightWave"},
    {"c4d", "Cinema 4D"},
    {"dxf", "DXF"},
    {"step", "STEP"},
    {"stp", "STEP"},
    {"iges", "IGES"},
    {"igs", "IGES"},
    {"usd", "USD"},
    {"usda", "USD"},
    {"usdc", "USD"},
    {"usdz", "USD"},
    {"mesh", "Medit"},
    {"msh", "Gmsh"},
    {"ifc", "IFC"},
    {"drc", "Draco"},
    {"smf", "SMF"},
    {"m", "Hoppe's format"},
    {"xyz", "a point cloud"},
    {"pts", "a point cloud"},
    {"pcd", "a point cloud"},
    {"las", "a point cloud"},
    {"laz", "a point cloud"},
    {"e57", "a point cloud"},
};

constexpr KnownEnding compressed[] = {{"gz", "gunzip"},   {"tgz", "tar"},   {"bz2", "bunzip2"}, {"xz", "unxz"},
                                      {"zst", "unzstd"},  {"zip", "unzip"}, {"7z", "7z"},       {"tar", "tar"},
                                      {"lzma", "unlzma"}, {"rar", "unrar"}};

constexpr std::string_view advice = "use OBJ, OFF, PLY or STL";

}  // namespace

std::string_view name_of(Format format) {
  switch (format) {
    case Format::obj:
      return "obj";
    case Format::off:
      return "off";
    case Format::ply:
      return "ply";
    case Format::stl:
      return "stl";
  }
  throw std::invalid_argument("not a format");
}

Format format_from_ending(std::string_view ending) {
  if (!ending.empty() && ending.front() == '.') ending.remove_prefix(1);
  std::string lower(ending);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Format format : all_formats) {
    if (lower == name_of(format)) return format;
  }
  for (const auto& [known, tool] : compressed) {
    if (lower == known) {
      throw std::invalid_argument("is compressed (." + lower + "), which is not supported; unpack it first (" +
                                  std::string(tool) + ")");
    }
  }
  for (const auto& [known, what] : not_read) {
    if (lower == known) {
      throw std::invalid_argument("is " + std::string(what) + " (." + lower + "), a format that is not supported; " +
                                  std::string(advice));
    }
  }
  if (lower.empty()) {
    throw std::invalid_argument("has no ending that tells its format; name one of obj, off, ply, stl");
  }
  throw std::invalid_argument("has the unknown ending \"." + std::string(ending) + "\"; " + std::string(advice));
}

Format format_of(const std::filesystem::path& path) { return format_from_ending(path.extension().string()); }

}  // namespace whittle::io
