# SPDX-License-Identifier: BSD-3-Clause
"""Runs a VTK algorithm: its errors become exceptions, Ctrl-C stops it."""

from __future__ import annotations

import re
import signal
import threading
from contextlib import contextmanager
from typing import Any, Iterator

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


class Error(RuntimeError):
    """What a class of Skyline or VTK reported, in its own words."""


def _reason(text: str) -> str:
    """The message without the place in the source and the object's address."""
    lines = text.strip().split("\n")
    if lines[0].startswith(("ERROR: In ", "Generic Warning: In ")):
        lines = lines[1:]
    return re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", " ".join(lines).strip())


@contextmanager
def _stopped_by_interrupt(algorithm: vtkAlgorithm) -> Iterator[None]:
    """VTK ends the program when a Python observer raises KeyboardInterrupt, so none may arise there:
    a signal asks the algorithm to stop, and its handler is called afterwards."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.getsignal(signal.SIGINT)
    caught: list[Any] = []

    def stop(number: int, frame: Any) -> None:
        caught.append((number, frame))
        algorithm.SetAbortExecute(1)

    if callable(before):
        signal.signal(signal.SIGINT, stop)
    # Python looks for signals when it runs, and in the midst of VTK that is here.
    tag = algorithm.AddObserver("ProgressEvent", lambda caller, event: None)
    try:
        yield
    finally:
        algorithm.RemoveObserver(tag)
        if callable(before):
            signal.signal(signal.SIGINT, before)
            if caught:
                algorithm.SetAbortExecute(0)
                before(*caught[0])


@contextmanager
def reported(*speakers: Any) -> Iterator[None]:
    """Raises the first error that the objects report in the block, in place of printing it."""
    reasons: list[str] = []

    def note(caller: Any, event: str, text: str) -> None:
        reasons.append(_reason(text))

    note.CallDataType = "string0"  # type: ignore[attr-defined]
    tags = [speaker.AddObserver("ErrorEvent", note) for speaker in speakers]
    try:
        yield
    finally:
        for speaker, tag in zip(speakers, tags):
            speaker.RemoveObserver(tag)
    if reasons:
        if "bad_alloc" in reasons[0]:
            raise MemoryError("not enough memory; take fewer azimuths or posts")
        raise Error(reasons[0])


def run(algorithm: vtkAlgorithm, update: Any = None) -> None:
    """Updates the algorithm, or calls `update`; raises Error with what it reports."""
    with reported(algorithm, algorithm.GetExecutive()), _stopped_by_interrupt(algorithm):
        (update or algorithm.Update)()
