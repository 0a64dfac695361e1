"""Conan 2, of the checkout that this file is part of: `conan create apps/packaging/conan --build=missing`."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

required_conan_version = ">=2.4"


class Whittle(ConanFile):
    name = "whittle"
    description = "Triangle mesh decimation: libraries, modules for OpenMesh, and a program"
    license = "BSD-3-Clause"
    homepage = "https://example.org/whittle"
    topics = ("mesh", "simplification", "decimation", "openmesh", "gltf")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"openmesh": [True, False], "compressed_gltf": [True, False], "program": [True, False]}
    default_options = {"openmesh": False, "compressed_gltf": False, "program": False}

    @property
    def _checkout(self):
        return Path(self.recipe_folder, "../../..").resolve()

    def set_version(self):
        project = load(self, self._checkout / "CMakeLists.txt").split("project(")[1]
        self.version = re.search(r"VERSION (\S+)", project)[1]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "modules/*", "apps/*", "docs/*"):
            copy(self, pattern, src=self._checkout, dst=self.export_sources_folder)

    def validate(self):
        check_min_cppstd(self, 20)

    def configure(self):
        if self.options.program:
            self.options.openmesh.value = True

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)
        self.requires("zlib/[>=1.2.11 <2]")
        self.requires("zstd/[>=1.5 <1.6]")
        # Headers that only the sources use.
        self.requires("fast_float/[>=3.5 <9]", visible=False)
        self.requires("nanoflann/[>=1.3 <2]", visible=False)
        self.requires("nlohmann_json/[>=3.11 <4]", visible=False)
        self.requires("xxhash/[>=0.8 <0.9]", visible=False)
        if self.options.openmesh:
            self.requires("openmesh/[>=9 <12]", transitive_headers=True)
        if self.options.compressed_gltf:
            self.requires("draco/[>=1.5 <1.6]")
            self.requires("meshoptimizer/[>=0.18 <1]")
        if self.options.program:
            self.requires("cli11/[>=2.3 <3]", visible=False)
            self.requires("libwebp/[>=1.2 <2]", visible=False)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        values = toolchain.cache_variables
        values["WHITTLE_BUILD_OPENMESH"] = bool(self.options.openmesh)
        values["WHITTLE_BUILD_APPS"] = bool(self.options.program)
        values["WHITTLE_BUILD_REPORT"] = False  # takes packages of npm while it is built
        values["WHITTLE_BUILD_RENDER"] = False  # takes the headers of EGL and OpenGL, which are no packages of Conan
        values["WHITTLE_BUILD_TESTS"] = False
        values["CMAKE_UNITY_BUILD"] = True  # takes less than half the time
        if not self.options.compressed_gltf:
            for package in ("draco", "meshoptimizer"):
                values[f"CMAKE_DISABLE_FIND_PACKAGE_{package}"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=Path(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # Whittle's own file for CMake says what each module needs.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/Whittle"]
