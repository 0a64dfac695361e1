"""The examples of the documentation run as they stand, but for those of libraries that are absent."""

import importlib.util
import os
import re
from pathlib import Path

import pytest

page = Path(os.environ["WHITTLE_SOURCE_DIR"]) / "docs" / "user" / "python.md"
blocks = re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)


def libraries_of(block):
    return re.findall(r"^import (\w+)", block, re.MULTILINE)


@pytest.mark.filterwarnings("error::UserWarning")
def test_examples(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert len(blocks) >= 8
    names = {}
    missing = set()
    for block in blocks:
        lacks = {name for name in libraries_of(block) if importlib.util.find_spec(name) is None}
        missing |= lacks
        if not lacks:
            exec(compile(block, str(page), "exec"), names)
    if missing:
        pytest.skip(f"not all examples ran: without {', '.join(sorted(missing))}")
