# Sourced after packages.sh by scripts that take sources, or packages of another release or machine, from Debian.

# What apt_apart tells apt-get beside, such as another architecture.
apt_options=()

# apt_apart FOLDER COMMAND...: apt-get in FOLDER and with lists of its own, so that those of this system stay as they are.
apt_apart() {
  (cd "$1" && apt-get -o Dir::Etc::SourceList="$1/sources.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$1/lists" \
    -o Dir::Cache="$1" -o APT::Sandbox::User="$(id -un)" -o Debug::NoLocking=1 "${apt_options[@]}" "${@:2}")
}

# Where this system has Debian's packages from.
debian_mirror() {
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' 'Component: main' |
    sed -n 1p
}

# open_lists FOLDER ROW...: gets the lists for apt_apart. A row is a kind and a release, such as "deb-src bookworm".
open_lists() {
  local folder=$1 row mirror
  mirror=$(debian_mirror)
  [ -n "$mirror" ] || fail "apt knows no mirror of Debian; 'apt-get update' may help"
  mkdir -p "$folder/lists/partial" "$folder/archives/partial"
  for row in "${@:2}"; do
    printf '%s [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] %s %s main\n' "${row% *}" "$mirror" "${row#* }"
  done >"$folder/sources.list"
  apt_apart "$folder" update
}
