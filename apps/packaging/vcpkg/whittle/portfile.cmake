# Builds the checkout that this file is part of: `vcpkg install whittle --overlay-ports=apps/packaging/vcpkg`.
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options
  FEATURES
    openmesh WHITTLE_BUILD_OPENMESH
    render WHITTLE_BUILD_RENDER
    tools WHITTLE_BUILD_APPS
  INVERTED_FEATURES
    compressed-gltf CMAKE_DISABLE_FIND_PACKAGE_draco
    compressed-gltf CMAKE_DISABLE_FIND_PACKAGE_meshoptimizer)

# The module whittle::report takes packages of npm while it is built, which ports must not.
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${options}
    -DWHITTLE_BUILD_REPORT=OFF
    -DWHITTLE_BUILD_TESTS=OFF
  MAYBE_UNUSED_VARIABLES
    CMAKE_DISABLE_FIND_PACKAGE_draco
    CMAKE_DISABLE_FIND_PACKAGE_meshoptimizer)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Whittle CONFIG_PATH lib/cmake/Whittle)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES whittle AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
     "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
