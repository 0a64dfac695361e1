#!/usr/bin/env bash
# Times Whittle beside other decimaters: installs the Debian packages of those that are asked for, builds them and ours,
# and runs them on the same meshes. Options are those of whittle_bench (--help tells them); without --mesh and --case
# it is the dragon, the bunny where it is to be had, and all made meshes. Rows are saved in build/bench/results.csv.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh
source apps/dragon.sh

work=build/bench
logs=$work/logs
peers=(meshoptimizer openmesh)
meshes_are_chosen=false
arguments=()

# The Debian packages of a peer.
packages_of() {
  case $1 in
    meshoptimizer) echo libmeshoptimizer-dev ;;
    openmesh) ;; # among those that building takes
    *) fail "no peer '$1'; there are meshoptimizer, openmesh, and whittle:N for whittle on N threads" ;;
  esac
}

# --peers a,b: all but whittle itself have to be installed and built.
take_peers() {
  local name
  peers=()
  for name in ${1//,/ }; do
    [[ $name == whittle || $name == whittle:* ]] || peers+=("$name")
  done
}

while [ $# -gt 0 ]; do
  case $1 in
    --peers)
      take_peers "${2:?--peers needs a list}"
      arguments+=(--peers "$2")
      shift
      ;;
    --mesh | --case)
      meshes_are_chosen=true
      arguments+=("$1")
      ;;
    *) arguments+=("$1") ;;
  esac
  shift
done

packages=()
for peer in "${peers[@]}"; do
  needed=$(packages_of "$peer") || exit 1
  [ -z "$needed" ] || packages+=("$needed")
done
install_packages "$logs/packages.log" "${build_packages[@]}" "${packages[@]}"

say "Building (preset release, into $work)"
configure=(cmake --preset release -B "$work" "-DWHITTLE_BENCH_PEERS=$(IFS=';' && echo "${peers[*]-}")")
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
OMP_NUM_THREADS=1 "$work/tests/bench/whittle_bench" --csv "$work/results.csv" --commit "$commit" "${arguments[@]}"
