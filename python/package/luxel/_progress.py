"""How far long work is: a bar in a notebook, a line on a terminal, nothing elsewhere."""

import importlib
import sys
import time
from collections.abc import Callable
from typing import Any

_PAUSE = 0.1
"""The least seconds between two updates."""


def bar(total: int, what: str = "pictures") -> Callable[[int], None]:
    """A bar of `total` steps: call it with the number of those done."""
    show = _in_notebook(total, what) or _on_terminal(total, what)
    last = float("-inf")

    def step(done: int) -> None:
        nonlocal last
        now = time.monotonic()
        if done >= total or now - last >= _PAUSE:
            last = now
            show(done)

    step(0)
    return step


def _in_notebook(total: int, what: str) -> Callable[[int], None] | None:
    ipython: Any = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from_ipython: Any = importlib.import_module("IPython.display")

    def page(done: int) -> Any:
        return from_ipython.HTML(f'<progress max="{max(total, 1)}" value="{done}"></progress> {done} of {total} {what}')

    handle = from_ipython.display(page(0), display_id=True)
    return lambda done: handle.update(page(done))


def _on_terminal(total: int, what: str) -> Callable[[int], None]:
    def show(done: int) -> None:
        if sys.stderr.isatty():
            end = "\n" if done >= total else ""
            print(f"\r{done} of {total} {what}", end=end, file=sys.stderr, flush=True)

    return show
