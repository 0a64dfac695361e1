# The address and the hash are those of no release yet: set both, then `brew install --formula ./whittle.rb`.
class Whittle < Formula
  desc "Simplifies triangle meshes and keeps their shape"
  homepage "https://example.org/whittle"
  url "https://example.org/whittle/whittle-0.1.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "BSD-3-Clause"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "fast_float" => :build
  depends_on "nanoflann" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "xxhash" => :build
  depends_on "draco"
  depends_on "eigen"
  depends_on "open-mesh"
  depends_on "webp"
  depends_on "zstd"

  uses_from_macos "zlib"

  def install
    # whittle::report takes packages of npm while it is built, and whittle::render a system with Mesa.
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *std_cmake_args,
           "-DCMAKE_UNITY_BUILD=ON", "-DWHITTLE_BUILD_REPORT=OFF", "-DWHITTLE_BUILD_RENDER=OFF",
           "-DWHITTLE_BUILD_TESTS=OFF"
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
    pkgshare.install "data/knot.ply"
  end

  test do
    cp pkgshare/"knot.ply", testpath
    system bin/"whittle", "simplify", "knot.ply", "-o", "small.ply", "--face-ratio", "10%"
    assert_match "5120 faces", shell_output("#{bin}/whittle info small.ply")
  end
end
