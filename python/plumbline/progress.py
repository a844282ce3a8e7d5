"""A sign of life for people who wait: in a notebook a bar, on a terminal a line, elsewhere nothing."""
from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any, Union

#: Called with the share of the work that is done; True for a bar where somebody can see it; None for nothing.
Progress = Union[Callable[[float], object], bool, None]


def _notebook() -> Any:
    """The display of the notebook that this runs in; or nothing."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython.display import HTML, display
    handle = display(HTML(""), display_id=True)
    return lambda share, words: handle.update(HTML(
        f'<progress max="1" value="{share:.3f}" aria-label="diagnosis"></progress> {words}' if share < 1 else ""))


def _terminal() -> Any:
    if not sys.stderr.isatty():
        return None

    def show(share: float, words: str) -> None:
        sys.stderr.write("\r\033[K" + (f"diagnosis: {words}" if share < 1 else ""))
        sys.stderr.flush()
    return show


def shown(progress: Progress) -> Callable[[float], object] | None:
    """What the engine is to call."""
    if progress is None or progress is False:
        return None
    if callable(progress):
        return progress
    show = _notebook() or _terminal()
    if show is None:
        return None
    begin, last = time.monotonic(), [0.0]

    def report(share: float) -> None:
        now = time.monotonic()
        if share < 1 and now - last[0] < 0.1:
            return
        last[0] = now
        show(share, f"{100 * share:.0f} %, {now - begin:.0f} s")
    return report
