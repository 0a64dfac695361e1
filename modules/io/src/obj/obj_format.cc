#include "format/format_row.hh"
#include "obj/obj.hh"

namespace whittle::io::detail {

namespace {

constexpr std::string_view obj_extensions[] = {"obj"};

}  // namespace

constinit const FormatRow obj_row{
    .format = Format::obj,
    .name = "obj",
    .title = "OBJ",
    .extensions = obj_extensions,
    .beginning = Beginning::text,
    .has_text_and_binary = false,
    .names_libraries = true,
    .names_textures = false,
    .recognises = nullptr,
    .read = read_obj,
    .write = write_obj,
};

}  // namespace whittle::io::detail
