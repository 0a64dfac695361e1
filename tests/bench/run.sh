#!/usr/bin/env bash
# Times Whittle beside other decimaters: installs the Debian packages of those that are asked for (--peers), builds them
# and ours, and runs them on the same meshes. Options are those of whittle_bench (--help tells them). Without --mesh and
# --case it is the dragon, the bunny where it is to be had, and all made meshes. Rows are saved in build/bench/results.csv.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh
source apps/dragon.sh

work=build/bench
logs=$work/logs
peers=whittle,whittle:2,whittle:3,whittle:8,meshoptimizer,openmesh,pair-decimater
meshes_are_chosen=false
arguments=()

# what_it_takes PEER: the name it has for CMake and its Debian package; nothing for what the project has anyway.
what_it_takes() {
  case $1 in
    whittle | whittle:* | openmesh | pair-decimater) ;;
    meshoptimizer) echo meshoptimizer libmeshoptimizer-dev ;;
    cgal-lindstrom-turk | cgal-garland-heckbert) echo cgal libcgal-dev ;;
    vtk) echo vtk libvtk9-dev ;;
    open3d) echo open3d libopen3d-dev ;;
    *) fail "no peer '$1'; there are whittle, whittle:N (N threads), meshoptimizer, openmesh, pair-decimater," \
      "cgal-lindstrom-turk, cgal-garland-heckbert, vtk, open3d" ;;
  esac
}

while [ $# -gt 0 ]; do
  case $1 in
    --peers)
      peers=${2:?--peers needs a list}
      shift
      ;;
    --peers=*) peers=${1#*=} ;;
    --mesh | --case | --mesh=* | --case=*)
      meshes_are_chosen=true
      arguments+=("$1")
      ;;
    *) arguments+=("$1") ;;
  esac
  shift
done

packages=()
built=()
for peer in ${peers//,/ }; do
  needed=$(what_it_takes "$peer") || exit 1
  [ -n "$needed" ] || continue
  built+=("${needed% *}")
  packages+=("${needed#* }")
done
install_packages "$logs/packages.log" "${build_packages[@]}" "${packages[@]}"

say "Building (preset release, into $work)"
configure=(cmake --preset release -B "$work" "-DWHITTLE_BENCH_PEERS=$(IFS=';' && echo "${built[*]}")")
quietly "$logs/configure.log" "${configure[@]}"
quietly "$logs/build.log" cmake --build "$work" --parallel "$(nproc)" --target whittle_bench

if ! $meshes_are_chosen; then
  arguments+=(--case all)
  if get_dragon build/demo; then
    arguments+=(--mesh build/demo/dragon_vrip.ply)
  else
    say "The dragon is not to be had (logs in build/demo): going without"
  fi
  bunny=../shared/data/meshes/bunny.obj
  [ ! -f "$bunny" ] || arguments+=(--mesh "$bunny")
fi

commit=$(git describe --always --dirty 2>/dev/null || echo unknown)
say "Measuring; the rows go to $work/results.csv"
# Peers that could work on several threads are measured on one, as ours is.
OMP_NUM_THREADS=1 "$work/tests/bench/whittle_bench" --peers "$peers" --csv "$work/results.csv" --commit "$commit" "${arguments[@]}"
