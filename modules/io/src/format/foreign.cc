#include "format/foreign.hh"

#include <algorithm>
#include <array>
#include <iterator>

#include "whittle/io/format.hh"

namespace whittle::io {

namespace {

using namespace std::string_view_literals;

struct Extension {
  std::string_view extension;
  std::string_view what;
};

/// A foreign format, and a way to convert it.
struct ForeignFormat {
  std::string_view extension;
  std::string_view what;
  std::string_view remedy;  ///< an imperative; empty = use one of the formats that are read
};

constexpr auto by_assimp = "convert it with assimp ('assimp export IN OUT.obj') or with Blender"sv;
constexpr auto by_blender = "open it in Blender and export glTF or PLY"sv;
constexpr auto by_meshlab = "import it in MeshLab and export PLY"sv;
constexpr auto by_paraview = "open it in ParaView and save its surface as PLY"sv;
constexpr auto by_gmsh = "convert it with Gmsh ('gmsh IN -save -o OUT.stl')"sv;
constexpr auto by_cad = "mesh it with FreeCAD, or with Gmsh ('gmsh IN -2 -o OUT.stl')"sv;
constexpr auto by_its_program = "export OBJ or glTF from the program that made it"sv;
constexpr auto by_surface = "it has no faces; make a surface of the points first, with MeshLab or CloudCompare"sv;

constexpr ForeignFormat foreign_formats[] = {
    {"glb", "glTF", ""},
    {"gltf", "glTF", ""},
    {"om", "OpenMesh's own format", "convert it with OpenMesh ('mconvert IN OUT.off')"},
    {"pm", "a progressive mesh", "write one of its levels as PLY or OFF with the program that made it"},
    {"3ds", "3D Studio", "convert it with assimp ('assimp export IN OUT.obj')"},
    {"max", "3ds Max", by_its_program},
    {"fbx", "FBX", by_assimp},
    {"dae", "Collada", by_assimp},
    {"vtk", "VTK", by_paraview},
    {"vtp", "VTK", by_paraview},
    {"vtu", "VTK", by_paraview},
    {"ctm", "OpenCTM", by_meshlab},
    {"3mf", "3MF", "convert it with assimp ('assimp export IN OUT.obj'), or export STL from a slicer"},
    {"amf", "AMF", "convert it with assimp ('assimp export IN OUT.obj'), or export STL from a slicer"},
    {"wrl", "VRML", by_meshlab},
    {"vrml", "VRML", by_meshlab},
    {"x3d", "X3D", by_meshlab},
    {"x3dv", "X3D", by_meshlab},
    {"blend", "a Blender scene", by_blender},
    {"ma", "Maya", by_its_program},
    {"mb", "Maya", by_its_program},
    {"lwo", "LightWave", "convert it with assimp ('assimp export IN OUT.obj')"},
    {"c4d", "Cinema 4D", by_its_program},
    {"skp", "SketchUp", by_its_program},
    {"dxf", "DXF", "convert it with assimp ('assimp export IN OUT.obj'), or export OBJ from FreeCAD"},
    {"dwg", "DWG", by_its_program},
    {"step", "STEP", by_cad},
    {"stp", "STEP", by_cad},
    {"iges", "IGES", by_cad},
    {"igs", "IGES", by_cad},
    {"brep", "BREP", by_cad},
    {"usd", "USD", by_blender},
    {"usda", "USD", by_blender},
    {"usdc", "USD", by_blender},
    {"usdz", "USD", by_blender},
    {"abc", "Alembic", by_blender},
    {"mesh", "Medit", by_gmsh},
    {"msh", "Gmsh", by_gmsh},
    {"ifc", "IFC", "convert it with IfcConvert ('IfcConvert IN OUT.obj')"},
    {"drc", "Draco", "unpack it with Draco ('draco_decoder -i IN -o OUT.ply')"},
    {"smf", "SMF", ""},
    {"m", "Hoppe's format", ""},
    {"xyz", "a point cloud", by_surface},
    {"pts", "a point cloud", by_surface},
    {"pcd", "a point cloud", by_surface},
    {"las", "a point cloud", by_surface},
    {"laz", "a point cloud", by_surface},
    {"e57", "a point cloud", by_surface},
    {"splat", "a cloud of splats", by_surface},
    {"spz", "a cloud of splats", by_surface},
};

// With the program that unpacks them.
constexpr Extension archive_extensions[] = {{"gz", "gunzip"},   {"tgz", "tar"},   {"bz2", "bunzip2"}, {"xz", "unxz"},
                                            {"zst", "unzstd"},  {"zip", "unzip"}, {"7z", "7z"},       {"tar", "tar"},
                                            {"lzma", "unlzma"}, {"rar", "unrar"}};

enum class Advice { convert, name_format, unpack, download_again, fetch };

struct Signature {
  std::string_view start;
  std::string_view what;
  Advice advice;
};

constexpr Signature signatures[] = {
    {"glTF"sv, "binary glTF", Advice::name_format},
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

/// The remedy for a file of a foreign format. \param what name in the table of formats; others have no remedy
std::string remedy_of(std::string_view what) {
  const auto* const row = std::find_if(std::begin(foreign_formats), std::end(foreign_formats),
                                       [what](const ForeignFormat& f) { return f.what == what; });
  if (row == std::end(foreign_formats) || row->remedy.empty()) return "use " + mesh_titles();
  return std::string(row->remedy);
}

// Names options of the program.
std::string text_of(Advice advice, std::string_view what) {
  switch (advice) {
    case Advice::convert:
      return "which is not supported; " + remedy_of(what);
    case Advice::name_format:
      return "rename it to .glb, or give --input-format glb";
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
  for (const auto& [known, what, remedy] : foreign_formats) {
    if (extension != known) continue;
    return "is " + std::string(what) + ' ' + shown + ", a format that is not supported; " +
           (what == "glTF" ? "use " + format_titles() : remedy_of(what));
  }
  return std::nullopt;
}

std::optional<std::string> problem_of_foreign_content(std::string_view bytes) {
  for (const auto& [start, what, advice] : signatures) {
    if (bytes.starts_with(start)) return "the content is " + std::string(what) + "; " + text_of(advice, what);
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
