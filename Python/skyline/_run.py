# SPDX-License-Identifier: BSD-3-Clause
"""Runs a VTK algorithm: its errors become exceptions, Ctrl-C stops it."""

from __future__ import annotations

import re
import signal
import threading
from contextlib import contextmanager
from typing import Any, Iterator

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _threads, _warnings


class Error(RuntimeError):
    """What a class of Skyline or VTK reported, in its own words."""


def _reason(text: str) -> str:
    """The message without the place in the source and the object's address."""
    lines = text.strip().split("\n")
    if lines[0].startswith(("ERROR: In ", "Warning: In ", "Generic Warning: In ")):
        lines = lines[1:]
    return re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", " ".join(lines).strip())


def _pipeline(algorithm: vtkAlgorithm) -> list[vtkAlgorithm]:
    """The algorithm and all that it takes its input from."""
    found = [algorithm]
    for part in found:  # which grows
        for port in range(part.GetNumberOfInputPorts()):
            for connection in range(part.GetNumberOfInputConnections(port)):
                source = part.GetInputAlgorithm(port, connection)
                if source is not None and source not in found:
                    found.append(source)
    return found


@contextmanager
def _stopped_by_interrupt(algorithms: list[vtkAlgorithm]) -> Iterator[None]:
    """VTK ends the program when a Python observer raises KeyboardInterrupt, so none may arise there:
    a signal asks the algorithms to stop, and its handler is called afterwards."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.getsignal(signal.SIGINT)
    caught: list[Any] = []

    def stop(number: int, frame: Any) -> None:
        caught.append((number, frame))
        for algorithm in algorithms:
            algorithm.SetAbortExecute(1)

    if callable(before):
        signal.signal(signal.SIGINT, stop)
    # Python looks for signals when it runs, and in the midst of VTK that is here.
    tags = [one.AddObserver("ProgressEvent", lambda caller, event: None) for one in algorithms]
    try:
        yield
    finally:
        for algorithm, tag in zip(algorithms, tags):
            algorithm.RemoveObserver(tag)
        if callable(before):
            signal.signal(signal.SIGINT, before)
            if caught:
                for algorithm in algorithms:
                    algorithm.SetAbortExecute(0)
                    algorithm.Modified()  # what was stopped has no result
                before(*caught[0])


@contextmanager
def reported(*speakers: Any) -> Iterator[None]:
    """Raises the first error that the objects report in the block, in place of printing it; without
    an error, their warnings become UserWarnings."""
    reasons: list[str] = []
    doubts: list[str] = []

    def note(caller: Any, event: str, text: str) -> None:
        (reasons if event == "ErrorEvent" else doubts).append(_reason(text))

    note.CallDataType = "string0"  # type: ignore[attr-defined]
    events = ("ErrorEvent", "WarningEvent")
    tags = [(speaker, speaker.AddObserver(event, note)) for speaker in speakers for event in events]
    try:
        yield
    finally:
        for speaker, tag in tags:
            speaker.RemoveObserver(tag)
    if not reasons:
        for text in dict.fromkeys(doubts):
            _warnings.warn(text)
    else:
        if "bad_alloc" in reasons[0]:
            raise MemoryError("not enough memory; take fewer azimuths or posts")
        raise Error(reasons[0])


def run(algorithm: vtkAlgorithm, call: Any = None) -> None:
    """Updates the algorithm, or makes the call that does; raises Error with what is reported."""
    _threads.prepare()
    algorithms = _pipeline(algorithm)
    speakers = algorithms + [one.GetExecutive() for one in algorithms]
    with reported(*speakers), _stopped_by_interrupt(algorithms):
        (call or algorithm.Update)()


def update(algorithm: vtkAlgorithm) -> None:
    """Updates a pipeline of VTK classes: an error of any of them is raised, Ctrl-C stops it.

    algorithm   the pipeline's end, for which Update() would print errors and could not be stopped

    >>> reader = vtkHeightFieldReader()
    >>> reader.SetFileName("nosuch.tif")
    >>> sky = vtkHeightFieldSkyView()
    >>> sky.SetInputConnection(reader.GetOutputPort())
    >>> try:
    ...     update(sky)
    ... except Error as reason:
    ...     print(str(reason)[:24])
    cannot read 'nosuch.tif'
    """
    if not isinstance(algorithm, vtkAlgorithm):
        raise TypeError(f"algorithm is {algorithm!r}; give a vtkAlgorithm")
    run(algorithm)
