"""The package's types, stubs and style."""

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import whittle

source = Path(os.environ["WHITTLE_SOURCE_DIR"])
package = source / "modules" / "python"


def run(*command):
    ran = subprocess.run(command, capture_output=True, text=True, cwd=source)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


def test_the_stub_is_that_of_the_options():
    printed = run(sys.executable, str(package / "stubs" / "make_stub.py"))
    assert printed == (package / "whittle" / "_simplify.pyi").read_text()


def test_the_stub_of_the_extension_has_its_names():
    tree = ast.parse((package / "whittle" / "_core.pyi").read_text())
    of_stub = {node.name: node for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    of_extension = {name for name in dir(whittle._core) if not name.startswith("_")}
    assert set(of_stub) == of_extension
    for name, node in of_stub.items():
        if isinstance(node, ast.ClassDef):
            members = {m.name for m in node.body if isinstance(m, ast.FunctionDef)}
            assert members <= set(dir(getattr(whittle._core, name))), name


def test_types():
    pytest.importorskip("mypy")
    run(sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, str(package / "whittle"))


def test_types_by_pyright():
    pyright = source / "build" / "npm" / "node_modules" / ".bin" / "pyright"
    if not pyright.exists():
        pytest.skip("npm hasn't installed pyright in build/npm")
    built = str(Path(whittle.__file__).parent)
    command = [str(pyright), "--pythonpath", sys.executable]
    run(*command, "--level", "error", built)
    assert "completeness score: 100%" in run(*command, "--verifytypes", "whittle", "--ignoreexternal")


def test_style():
    ruff = shutil.which("ruff", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    if ruff is None:
        pytest.skip("ruff is not there")
    checked = [
        "modules/python",
        "tests/python",
        "tests/blender",
        "tests/bench",
        "apps/blender",
        "apps/paraview",
        "docs/notebooks",
    ]
    run(ruff, "check", "--no-cache", *checked)
    run(ruff, "format", "--no-cache", "--check", *checked)
