"""The examples of the documentation run as they stand, but for those of libraries that are absent."""

import importlib.util
import os
import re
from pathlib import Path

import pytest

source = Path(os.environ["WHITTLE_SOURCE_DIR"])


def blocks_of(page):
    return re.findall(r"```python\n(.*?)```", (source / page).read_text(), re.DOTALL)


def libraries_of(block):
    return re.findall(r"^import (\w+)", block, re.MULTILINE)


@pytest.mark.filterwarnings("error::UserWarning")
def test_examples(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = blocks_of("docs/user/python.md")
    assert len(blocks) >= 8
    names = {}
    missing = set()
    for block in blocks:
        lacks = {name for name in libraries_of(block) if importlib.util.find_spec(name) is None}
        missing |= lacks
        if not lacks:
            exec(compile(block, "python.md", "exec"), names)
    if missing:
        pytest.skip(f"not all examples ran: without {', '.join(sorted(missing))}")


def test_example_of_the_readme(monkeypatch, capsys):
    monkeypatch.chdir(source / "data")
    (block,) = blocks_of("README.md")
    exec(compile(block, "README.md", "exec"), {})
    assert capsys.readouterr().out.startswith("5120 ")
