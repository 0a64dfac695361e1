# Files that can't take the version out of project() name the same one: VERSION, in the tree SOURCE.
set(rows
    "CITATION.cff|\nversion: ([0-9.]+)"
    "README.md|whittle_([0-9.]+)_amd64.deb"
    "README.md|whittle-([0-9.]+)-linux"
    "apps/packaging/vcpkg/whittle/vcpkg.json|\"version\": \"([0-9.]+)\""
    "apps/packaging/homebrew/whittle.rb|whittle-([0-9.]+)\\.tar"
    "apps/packaging/nix/default.nix|version = \"([0-9.]+)\"")
foreach(row IN LISTS rows)
  string(REGEX MATCH "^([^|]+)\\|(.*)$" unused "${row}")
  set(file ${CMAKE_MATCH_1})
  set(pattern "${CMAKE_MATCH_2}")
  file(READ ${SOURCE}/${file} text)
  if(NOT text MATCHES "${pattern}")
    message(SEND_ERROR "${file} names no version (${pattern})")
  elseif(NOT CMAKE_MATCH_1 STREQUAL VERSION)
    message(SEND_ERROR "${file} names the version ${CMAKE_MATCH_1}, and project() ${VERSION}")
  endif()
endforeach()
