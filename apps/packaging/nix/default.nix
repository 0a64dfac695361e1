# The checkout that this file is part of: `nix-build apps/packaging/nix`.
{
  pkgs ? import <nixpkgs> { },
}:

pkgs.stdenv.mkDerivation {
  pname = "whittle";
  version = "0.1.0";
  src = pkgs.lib.cleanSource ../../..;

  nativeBuildInputs = with pkgs; [
    cmake
    ninja
  ];
  buildInputs = with pkgs; [
    cli11
    draco
    fast-float
    libwebp
    meshoptimizer
    nanoflann
    nlohmann_json
    xxHash
  ];
  # What the installed files for CMake and pkg-config ask for.
  propagatedBuildInputs = with pkgs; [
    eigen
    openmesh
    zlib
    zstd
  ];

  # whittle::report takes packages of npm while it is built, which Nix doesn't allow; whittle::render looks for libEGL
  # where the system has it.
  cmakeFlags = [
    "-DCMAKE_UNITY_BUILD=ON"
    "-DWHITTLE_BUILD_RENDER=OFF"
    "-DWHITTLE_BUILD_REPORT=OFF"
    "-DWHITTLE_BUILD_TESTS=OFF"
  ];

  doInstallCheck = true;
  installCheckPhase = ''
    runHook preInstallCheck
    $out/bin/whittle simplify ../data/knot.ply -o small.ply --face-ratio 10%
    $out/bin/whittle info small.ply | grep -q "5120 faces"
    runHook postInstallCheck
  '';

  meta = with pkgs.lib; {
    description = "Simplifies triangle meshes and keeps their shape";
    homepage = "https://example.org/whittle";
    license = licenses.bsd3;
    mainProgram = "whittle";
    platforms = platforms.unix;
  };
}
