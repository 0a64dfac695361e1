"""Prints the stub of `whittle._simplify`, with all options: python stubs/make_stub.py > whittle/_simplify.pyi"""

import inspect
import re

import whittle
from whittle import _simplify

FIXED = """\
# Made by stubs/make_stub.py from the program's table of options.
from collections.abc import Callable, Mapping
from os import PathLike
from typing import Any, Literal, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._mesh import Mesh

_Given = TypeVar("_Given")
"""


def type_of(option: whittle._options.Option) -> str:
    """The type of an option's values, by what stands for them in the help: "keep|free", "N", "R", "E"."""
    if not option.meta:
        return "bool"
    if re.fullmatch(r"[a-z-]+(\|[a-z-]+)+", option.meta):
        return "Literal[" + ", ".join(f'"{word}"' for word in option.meta.split("|")) + "]"
    if option.meta in ("N", "K"):
        return "int"
    if option.meta in ("FILE",):
        return "str"
    if "NAME" in option.meta or "=" in option.meta:
        return "str | list[str] | Mapping[str, float]"
    return "float | str"


def properties_of(described: type) -> str:
    lines = [f"class {described.__name__}(Mesh):"]
    for name, member in vars(described).items():
        if isinstance(member, property) and member.fget is not None and not name.startswith("_"):
            result = inspect.signature(member.fget).return_annotation
            lines += ["    @property", f"    def {name}(self) -> {result}: ..."]
    return "\n".join(lines) + "\n"


def simplify(first: str, result: str) -> str:
    given = inspect.signature(inspect.unwrap(_simplify.simplify)).parameters
    lines = ["@overload", "def simplify(", first, "    *,"]
    kinds = {
        "normals": "ArrayLike | None",
        "colors": "ArrayLike | None",
        "texcoords": "ArrayLike | None",
        "attributes": "Mapping[str, ArrayLike] | None",
        "locked": "ArrayLike | None",
        "certificate": "bool",
        "record": "bool",
        "as_result": "bool",
        "progress": "Callable[[str, float], Any] | type | None",
        "threads": "int",
    }
    for name, parameter in given.items():
        if name in kinds:
            lines.append(f"    {name}: {kinds[name]} = {parameter.default},")
    lines += [f"    {option.name}: {type_of(option)} | None = None," for option in whittle.OPTIONS.values()]
    lines.append(f") -> {result}: ...")
    return "\n".join(lines) + "\n"


def main() -> None:
    print(FIXED)
    print(properties_of(whittle.Result))
    print(simplify("    mesh: ArrayLike,\n    faces: ArrayLike,", "Result"), end="")
    print(
        simplify(
            "    mesh: Mesh | tuple[ArrayLike, ArrayLike] | str | PathLike[str],\n    faces: None = None,", "Result"
        ),
        end="",
    )
    print(simplify("    mesh: _Given,\n    faces: None = None,", "_Given"), end="")


if __name__ == "__main__":
    main()
