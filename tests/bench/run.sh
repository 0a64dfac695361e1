#!/usr/bin/env bash
# Times Whittle beside other decimaters on the same meshes. Installs and builds what that needs:
#   run.sh [OPTION]...             the engine beside the libraries of --peers; options are those of whittle_bench
#   run.sh --programs [OPTION]...  `whittle simplify` beside other programs; options are those of whittle_bench_programs
#   run.sh --max-error [OPTION]... results with a length as target: proofs, faces, time, beside the marks that were set;
#                                  options are those of whittle_bench_max_error
# Without --mesh (and --case) both forms use the dragon. The first form also uses the bunny, if available, and all
# generated meshes, each also in random order; this takes a quarter of an hour. --help after either form lists the
# options. Rows are saved in build/bench/results.csv and programs.csv. --plot, here without a folder, draws results.csv
# in build/bench/plots.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh
source apps/dragon.sh

work=build/bench
logs=$work/logs
bin=$work/tests/bench
peers=
measure=measure_engine
mesh_is_chosen=false
arguments=()

while [ $# -gt 0 ]; do
  case $1 in
    --programs) measure=measure_programs ;;
    --max-error) measure=measure_max_error ;;
    --peers)
      peers=${2:?--peers needs a list}
      shift
      ;;
    --plot) arguments+=(--plot "$work/plots") ;;
    --peers=*) peers=${1#*=} ;;
    --mesh | --case | --efficiency | --folder | --mesh=* | --case=* | --efficiency=* | --folder=*)
      mesh_is_chosen=true
      arguments+=("$1")
      ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
commit=$(git describe --always --dirty 2>/dev/null || echo unknown)
arguments+=(--commit "$commit")

# what_it_takes PEER: its name in CMake and its Debian package; nothing for peers that the project contains anyway.
what_it_takes() {
  case $1 in
    whittle | whittle:* | whittle-normal* | whittle-best* | whittle-quadric* | openmesh | openmesh-hausdorff | pair-decimater) ;;
    meshlab) echo meshlab meshlab xvfb xauth libgl1-mesa-dri ;;
    meshoptimizer | meshoptimizer-error) echo meshoptimizer libmeshoptimizer-dev ;;
    cgal | cgal-lindstrom-turk | cgal-garland-heckbert | cgal-envelope) echo cgal libcgal-dev ;;
    vtk) echo vtk libvtk9-dev ;;
    open3d) echo open3d libopen3d-dev ;;
    *) fail "no peer '$1'; there are whittle, whittle-normal, whittle-best, whittle-quadric, each with :N (N threads), meshoptimizer, openmesh," \
      "pair-decimater, cgal-lindstrom-turk, cgal-garland-heckbert, vtk, open3d; with --max-error also openmesh-hausdorff," \
      "meshoptimizer-error, cgal-envelope, meshlab" ;;
  esac
}

# build_with PEERS TARGET...: PEERS as a CMake list, separated by semicolons.
build_with() {
  local built=$1
  shift
  say "Building (preset release, into $work)"
  quietly "$logs/configure.log" cmake --preset release -B "$work" "-DWHITTLE_BENCH_PEERS=$built"
  quietly "$logs/build.log" cmake --build "$work" --parallel "$(nproc)" --target "$@"
}

choose_dragon() {
  if get_dragon build/demo; then
    arguments+=(--mesh build/demo/dragon_vrip.ply)
  else
    say "The dragon is not to be had (logs in build/demo): going without"
    return 1
  fi
}

choose_meshes() {
  local bunny=../shared/data/meshes/bunny.obj
  arguments+=(--case all --permuted)
  choose_dragon || true
  [ ! -f "$bunny" ] || arguments+=(--mesh "$bunny")
}

# build_for PEERS TARGET...: installs what a list with commas needs, and builds.
build_for() {
  local peer needed
  local -a packages=() built=()
  for peer in ${1//,/ }; do
    needed=$(what_it_takes "$peer") || exit 1
    [ -n "$needed" ] || continue
    built+=("${needed%% *}")
    # shellcheck disable=SC2206 # several packages
    packages+=(${needed#* })
  done
  install_packages "$logs/packages.log" "${build_packages[@]}" "${packages[@]}"
  build_with "$(IFS=';' && echo "${built[*]}")" "${@:2}"
}

measure_engine() {
  : "${peers:=whittle,whittle:2,whittle:3,whittle:8,meshoptimizer,openmesh,pair-decimater}"
  build_for "$peers" whittle_bench
  $mesh_is_chosen || choose_meshes
  say "Measuring; the rows go to $work/results.csv"
  # Peers that can use several threads are measured on one, like Whittle.
  OMP_NUM_THREADS=1 "$bin/whittle_bench" --peers "$peers" --csv "$work/results.csv" "${arguments[@]}"
}

# The tests of proofs in rational arithmetic, and of certificates that were changed.
test_proofs() {
  say "Testing 10,000 random pairs against rational arithmetic"
  "$work/tests/unit/metrics/test_metrics" --gtest_brief=1 --gtest_filter=Certify.IsRightInRationalArithmetic
  say "Testing 100,000 changed certificates, and 4,000 of changed meshes"
  "$work/tests/unit/verify/test_verify" --gtest_brief=1 --gtest_filter='Mutations.*'
}

choose_max_error_meshes() {
  local folder=../shared/data/meshes name
  if [ ! -d "$folder" ]; then
    arguments+=(--folder data)
    choose_dragon || true
    return
  fi
  for name in bunny.obj armadillo_86k.obj dragon_vrip.ply kitten.obj fandisk.obj couplingdown.off camelhead.off \
    lion-head.off three_peaks.off bun_zipper.ply; do
    [ ! -f "$folder/$name" ] || arguments+=(--mesh "$folder/$name")
  done
  arguments+=(--folder "$folder")
}

measure_max_error() {
  local -a display=()
  : "${peers:=meshlab,cgal-lindstrom-turk,cgal-garland-heckbert,cgal-envelope,openmesh-hausdorff,meshoptimizer-error}"
  build_for "$peers,cgal" whittle_bench_max_error test_metrics test_verify
  $mesh_is_chosen || test_proofs
  $mesh_is_chosen || choose_max_error_meshes
  case $peers in *meshlab*) display=(xvfb-run --auto-servernum) ;; esac
  say "Measuring; the rows go to $work/max_error.csv"
  "${display[@]}" "$bin/whittle_bench_max_error" --peers "$peers" --csv "$work/max_error.csv" "${arguments[@]}"
}

# gltfpack comes as an npm package (1 MB).
get_gltfpack() {
  [ ! -x "$work/npm/node_modules/.bin/gltfpack" ] || return 0
  (install_npm "$logs/npm-packages.log") || return 1
  npm install --prefix "$work/npm" --fetch-retries=1 gltfpack@1.3.0 </dev/null >"$logs/npm.log" 2>&1
}

measure_programs() {
  install_packages "$logs/packages.log" "${build_packages[@]}" libmeshoptimizer-dev libopenmesh-apps
  build_with meshoptimizer whittle whittle_bench_programs meshoptimizer_obj
  if get_gltfpack; then
    arguments+=(--gltfpack "$work/npm/node_modules/.bin/gltfpack")
  else
    say "gltfpack is not to be had (log in $logs): going without"
  fi
  if ! $mesh_is_chosen && ! choose_dragon; then arguments+=(--mesh data/knot.ply); fi
  say "Measuring; the rows go to $work/programs.csv"
  "$bin/whittle_bench_programs" --whittle "$work/bin/whittle" --openmesh OpenMesh-commandlineDecimater \
    --meshoptimizer "$bin/meshoptimizer_obj" --folder "$work/programs" --csv "$work/programs.csv" "${arguments[@]}"
}

$measure
