"""The options of `simplify`: those of the program, by its table of options."""

from __future__ import annotations

import inspect
import textwrap
from dataclasses import dataclass
from typing import Any

from . import _core

# Of options that have names of their own in Python, where `faces`, `normals` and `attributes` are the mesh's.
_NAMES = {
    "--faces": "faces_left",
    "--vertices": "vertices_left",
    "--normals": "out_normals",
    "--attributes": "out_attributes",
}


@dataclass(frozen=True)
class Option:
    """An option of `simplify`."""

    name: str  #: in Python: "max_error"
    option: str  #: of the program: "--max-error"
    meta: str  #: what stands for its value: "R", "keep|free"; empty for a flag, which is True or False
    group: str
    help: str
    default: str


def _options() -> dict[str, Option]:
    options = {}
    for row in _core.option_rows():
        name = _NAMES.get(row.name, row.name.removeprefix("--").replace("-", "_"))
        options[name] = Option(name, row.name, row.meta, row.group, row.help, row.standard)
    return options


#: All options of `simplify`, by name.
OPTIONS: dict[str, Option] = _options()


def as_text(value: Any) -> str:
    """A value as on the command line: 0.5 → "0.5", ["a", "b"] → "a,b", [] → "none"."""
    if isinstance(value, (list, tuple, set)):
        return ",".join(as_text(v) for v in value) or "none"
    if isinstance(value, dict):
        return ",".join(f"{key}={as_text(v)}" for key, v in value.items())
    if isinstance(value, bool):
        return "on" if value else "off"
    return str(value)


def given(options: dict[str, Any]) -> list[tuple[str, str]]:
    """Options as the program names them. None stands for one that isn't given."""
    result = []
    for name, value in options.items():
        if name not in OPTIONS:
            raise TypeError(f"simplify() got an unexpected keyword argument '{name}'")
        option = OPTIONS[name]
        if value is None or (not option.meta and value is False):
            continue
        if not option.meta and value is not True:
            raise ValueError(f"{option.option} is on or off: {name} is True or False")
        result.append((option.option, as_text(value) if option.meta else ""))
    return result


def describe() -> str:
    """The options, for the docstring."""
    lines = []
    group = None
    for option in OPTIONS.values():
        if option.group != group:
            group = option.group
            lines += ["", f"{group}:" if group else "Options:"]
        default = f" (default: {option.default})" if option.default else ""
        text = f"{option.name}: {option.meta or 'True'}. {option.help}{default}"
        lines += textwrap.wrap(text, 100, initial_indent="    ", subsequent_indent="        ")
    return "\n".join(lines)


def with_options(function: Any) -> Any:
    """Gives a function with **options a signature and a docstring that name them."""
    signature = inspect.signature(function)
    parameters = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in OPTIONS]
    function.__signature__ = signature.replace(parameters=parameters)
    function.__doc__ = inspect.cleandoc(function.__doc__) + "\n" + describe() + "\n"
    return function
