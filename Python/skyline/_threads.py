# SPDX-License-Identifier: BSD-3-Clause
"""Limits the threads of VTK to what the system allows; TBB ends a program that gets fewer."""

from __future__ import annotations

import functools
import threading

from vtkmodules.vtkCommonCore import vtkSMPTools


def _count(wanted: int) -> int:
    """How many of `wanted` threads the system allows, including the current one."""
    gate = threading.Event()
    others: list[threading.Thread] = []
    try:
        while len(others) + 1 < wanted:
            other = threading.Thread(target=gate.wait)
            other.start()
            others.append(other)
    except (RuntimeError, MemoryError):
        pass  # the system allows no more
    finally:  # also after an interrupt
        gate.set()
        for other in others:
            other.join()
    return len(others) + 1


@functools.lru_cache(None)
def prepare() -> None:
    """Runs once, before the first computation."""
    wanted = vtkSMPTools.GetEstimatedNumberOfThreads()
    given = _count(wanted)
    if given < wanted:
        if given == 1:
            vtkSMPTools.SetBackend("Sequential")
        else:
            vtkSMPTools.Initialize(given)
