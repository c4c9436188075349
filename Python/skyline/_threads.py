# SPDX-License-Identifier: BSD-3-Clause
"""VTK gets the threads that the system gives: TBB ends a program that is refused one."""

from __future__ import annotations

import functools
import threading

from vtkmodules.vtkCommonCore import vtkSMPTools


def _count(wanted: int) -> int:
    """How many threads of `wanted` the system gives, the one that runs included."""
    gate = threading.Event()
    others: list[threading.Thread] = []
    try:
        while len(others) + 1 < wanted:
            other = threading.Thread(target=gate.wait)
            other.start()
            others.append(other)
    except (RuntimeError, MemoryError):
        pass  # no more
    finally:  # an interrupt too
        gate.set()
        for other in others:
            other.join()
    return len(others) + 1


@functools.lru_cache(None)
def prepare() -> None:
    """Once, before the first computation."""
    wanted = vtkSMPTools.GetEstimatedNumberOfThreads()
    given = _count(wanted)
    if given < wanted:
        if given == 1:
            vtkSMPTools.SetBackend("Sequential")
        else:
            vtkSMPTools.Initialize(given)
