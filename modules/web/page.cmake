# The page that simplifies: simplify.html, one file with the viewer of whittle::report, and with a module of WebAssembly
# of everything from reading files to packing what is shown.
set(page_flags -I${CMAKE_CURRENT_SOURCE_DIR}/src -include ${CMAKE_CURRENT_SOURCE_DIR}/src/support/with_files.hh -DXXH_INLINE_ALL
               -D_WASI_EMULATED_GETPID -Wno-tautological-constant-out-of-range-compare)
foreach(module io gltf scene metrics pipeline progressive report)
  list(APPEND page_flags -I${PROJECT_SOURCE_DIR}/modules/${module}/include)
endforeach()
# Headers of other projects, after those of the system for WebAssembly.
foreach(target FastFloat::fast_float nanoflann::nanoflann nlohmann_json::nlohmann_json)
  list(APPEND page_flags "-idirafter$<JOIN:$<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>,;-idirafter>")
endforeach()
list(APPEND page_flags -idirafter /usr/include)

set(page_names ${core_names})
foreach(module io gltf scene metrics pipeline progressive report)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/modules/${module}/src/*.cc)
  # src/page has others for these; the page as a text is not written.
  list(FILTER sources EXCLUDE REGEX "/io/src/bytes/gzip.cc$|/gltf/src/codec/meshopt.cc$|/report/src/(encoding|page_html).cc$")
  whittle_wasm_object(${module} FLAGS -Os -I${PROJECT_SOURCE_DIR}/modules/${module}/src ${page_flags} SOURCES ${sources})
  list(APPEND page_names ${module})
endforeach()
file(GLOB sources CONFIGURE_DEPENDS src/page/*.cc)
whittle_wasm_object(page FLAGS -Os ${page_flags} SOURCES ${sources} ${runtime} ${CMAKE_CURRENT_SOURCE_DIR}/src/support/filesystem.cc)
whittle_wasm(${objects_folder}/page.wasm ${page_names} page)

set(simplify_page ${PROJECT_BINARY_DIR}/web/simplify.html)
file(GLOB page_sources CONFIGURE_DEPENDS page/*.* page/src/*.js whittle/errors.js ${PROJECT_SOURCE_DIR}/modules/report/viewer/*.*
     ${PROJECT_SOURCE_DIR}/modules/report/viewer/src/*.js)
add_custom_command(
  OUTPUT ${simplify_page}
  COMMAND ${WHITTLE_NODE} ${CMAKE_CURRENT_SOURCE_DIR}/page/build.mjs ${PROJECT_BINARY_DIR}/modules/report/viewer ${objects_folder}/page.wasm
          ${simplify_page}
  DEPENDS ${page_sources} ${objects_folder}/page.wasm
  VERBATIM)
add_custom_target(whittle_web_page ALL DEPENDS ${simplify_page})
