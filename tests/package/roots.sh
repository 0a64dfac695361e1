# shellcheck shell=bash disable=SC2154 # who sources it sets them
# Sourced by debian.sh and portable.sh: fresh root folders of Debian, and the README's examples in them. They set `work`, a
# folder for the roots and logs, and `root`, the root that is used.
source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$source_folder/apps/packages.sh"

skip() {
  say "skipped: $*"
  exit 77
}

# need_roots PROGRAM...: ends the test where no roots can be made, or one of the programs is missing.
need_roots() {
  local program
  [ "$(id -u)" = 0 ] || skip "only root makes a root folder"
  for program in debootstrap unshare "$@"; do
    command -v "$program" >/dev/null || skip "there is no $program"
  done
}

# fresh_root RELEASE: a minimal Debian as $root. A copy of it is kept for the next time.
fresh_root() {
  local base=$work/$1
  if [ ! -e "$base.done" ]; then
    say "Getting Debian's $1"
    rm -rf "$base"
    quietly "$work/debootstrap.log" debootstrap --variant=minbase "$1" "$base"
    touch "$base.done"
  fi
  rm -rf "$root"
  cp -a "$base" "$root"
  cp /etc/resolv.conf "$root/etc/"
}

# in_root COMMAND...: the mounts are gone when it ends.
in_root() {
  # shellcheck disable=SC2016 # the inner shell expands them
  unshare --mount --propagation private sh -c '
    mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"' "$root" \
    env -i HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+"http_proxy=$http_proxy"} "$@"
}

# A line a command, out of a block of the README: those with a "$ " before them, or all lines of the first block of sh.
commands_of_readme() {
  sed -n 's/^\$ //p' "$source_folder/README.md"
  awk '/^## Using the program/ {here = 1} here && /^```$/ {exit} block {print} here && /^```sh$/ {block = 1}' \
    "$source_folder/README.md"
}

# The examples, one after the other, in a folder with the meshes of data/ and a glTF file of the name that they use.
run_examples() {
  local command n=0
  mkdir -p "$root/examples"
  cp "$source_folder"/data/*.{ply,obj,off,stl} "$root/examples"
  in_root sh -c 'cd /examples && whittle convert knot.ply helmet.glb'
  commands_of_readme >"$work/examples.txt"
  while read -r command; do
    say "$command"
    in_root bash -c "set -euo pipefail; cd /examples; $command" </dev/null || fail "the example failed: $command"
    n=$((n + 1))
  done <"$work/examples.txt"
  [ "$n" -ge 10 ] || fail "only $n examples were found in README.md"
}
