"""How long calls tell how far they are."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import contextmanager
from typing import Any


class _Bars:
    """A bar for each stage, of a class such as tqdm's."""

    def __init__(self, make: Any) -> None:
        self._make = make
        self._stage: str | None = None
        self._bar: Any = None

    def __call__(self, stage: str, fraction: float) -> None:
        if stage != self._stage:
            self.close()
            self._stage = stage
            self._bar = self._make(total=1000, desc=stage)
        self._bar.update(round(1000 * fraction) - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


@contextmanager
def told(progress: Any) -> Any:
    """\\param progress None, a callable that takes a stage and its fraction, or a class such as tqdm.tqdm"""
    is_class_of_bars = hasattr(progress, "update") and isinstance(progress, type)
    callable_: Callable[[str, float], Any] | None = _Bars(progress) if is_class_of_bars else progress
    try:
        yield callable_
    finally:
        if isinstance(callable_, _Bars):
            callable_.close()
