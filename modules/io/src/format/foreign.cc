#include "format/foreign.hh"

#include <array>

#include "whittle/io/format.hh"

namespace whittle::io {

namespace {

using namespace std::string_view_literals;

struct Extension {
  std::string_view extension;
  std::string_view what;
};

constexpr Extension mesh_extensions[] = {
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

// With the program that unpacks them.
constexpr Extension archive_extensions[] = {{"gz", "gunzip"},   {"tgz", "tar"},   {"bz2", "bunzip2"}, {"xz", "unxz"},
                                            {"zst", "unzstd"},  {"zip", "unzip"}, {"7z", "7z"},       {"tar", "tar"},
                                            {"lzma", "unlzma"}, {"rar", "unrar"}};

enum class Advice { convert, unpack, download_again, fetch };

struct Signature {
  std::string_view start;
  std::string_view what;
  Advice advice;
};

constexpr Signature signatures[] = {
    {"glTF"sv, "binary glTF", Advice::convert},
    {"Kaydara FBX"sv, "FBX", Advice::convert},
    {"OCTM"sv, "OpenCTM", Advice::convert},
    {"# vtk DataFile"sv, "VTK", Advice::convert},
    {"#VRML"sv, "VRML", Advice::convert},
    {"#X3D"sv, "X3D", Advice::convert},
    {"BLENDER"sv, "a Blender scene", Advice::convert},
    {"DRACO"sv, "Draco", Advice::convert},
    {"ISO-10303-21"sv, "STEP", Advice::convert},
    {"<?xml"sv, "XML (Collada, VTK, X3D...)", Advice::convert},
    {"<!DOCTYPE"sv, "a web page", Advice::download_again},
    {"<html"sv, "a web page", Advice::download_again},
    {"version https://git-lfs"sv, "a Git LFS pointer, not the mesh itself", Advice::fetch},
    {"PK\x03\x04"sv, "a zip archive", Advice::unpack},
    {"\x1F\x8B"sv, "compressed with gzip", Advice::unpack},
    {"BZh"sv, "compressed with bzip2", Advice::unpack},
    {"\xFD"
     "7zXZ"sv,
     "compressed with xz", Advice::unpack},
    {"\x28\xB5\x2F\xFD"sv, "compressed with zstd", Advice::unpack},
    {"7z\xBC\xAF"sv, "a 7z archive", Advice::unpack},
};

constexpr std::string_view utf16_marks[] = {"\xFF\xFE"sv, "\xFE\xFF"sv};

std::string text_of(Advice advice) {
  switch (advice) {
    case Advice::convert:
      return "which is not supported; use " + format_titles();
    case Advice::unpack:
      return "which is not supported; unpack it first";
    case Advice::download_again:
      return "the download went wrong";
    case Advice::fetch:
      return "run git lfs pull";
  }
  return {};
}

}  // namespace

std::optional<std::string> problem_of_foreign_extension(std::string_view extension) {
  const std::string shown = "(." + std::string(extension) + ")";
  for (const auto& [known, tool] : archive_extensions) {
    if (extension != known) continue;
    return "is compressed " + shown + ", which is not supported; unpack it first (" + std::string(tool) + ")";
  }
  for (const auto& [known, what] : mesh_extensions) {
    if (extension != known) continue;
    return "is " + std::string(what) + ' ' + shown + ", a format that is not supported; use " + format_titles();
  }
  return std::nullopt;
}

std::optional<std::string> problem_of_foreign_content(std::string_view bytes) {
  for (const auto& [start, what, advice] : signatures) {
    if (bytes.starts_with(start)) return "the content is " + std::string(what) + "; " + text_of(advice);
  }
  for (const std::string_view mark : utf16_marks) {
    if (bytes.starts_with(mark)) return std::string(problem_of_utf16);
  }
  return std::nullopt;
}

// Every second byte of ASCII text in UTF-16 is zero.
bool looks_like_utf16(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 64);
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < start.size(); ++i) zeros[i % 2] += start[i] == '\0';
  const std::size_t half = start.size() / 2;
  return half > 2 && ((zeros[0] >= half - 1 && zeros[1] == 0) || (zeros[1] >= half - 1 && zeros[0] == 0));
}

}  // namespace whittle::io
