"""The source distribution, of which pip makes the wheel."""

import os
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

source = Path(os.environ["WHITTLE_SOURCE_DIR"])


def test_source_distribution(tmp_path):
    pytest.importorskip("build")
    pytest.importorskip("twine")
    command = [sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", str(tmp_path), str(source)]
    subprocess.run(command, check=True, capture_output=True)
    (archive,) = tmp_path.glob("whittle-*.tar.gz")
    checked = [sys.executable, "-m", "twine", "check", "--strict", str(archive)]
    assert "PASSED" in subprocess.run(checked, check=True, capture_output=True, text=True).stdout
    with tarfile.open(archive) as tar:
        names = {name.split("/", 1)[-1] for name in tar.getnames()}
        (about,) = [name for name in tar.getnames() if name.endswith("/PKG-INFO")]
        metadata = tar.extractfile(about).read().decode()
    for needed in ("LICENSE", "CMakeLists.txt", "pyproject.toml", "modules/python/whittle/_libraries/vtk.py"):
        assert needed in names
    # All that the build reads, and nothing that it doesn't need.
    folders = {name.split("/")[0] for name in names if "/" in name}
    assert {"modules", "apps"} <= folders
    assert not folders & {"build", "tests", "data", ".ci", ".git"}
    assert archive.stat().st_size < 3e6
    assert "License-Expression: BSD-3-Clause" in metadata
    assert "License-File: LICENSE" in metadata
