# SPDX-License-Identifier: BSD-3-Clause
"""Runs a VTK algorithm: its errors and its observers' become exceptions, Ctrl-C stops it, other threads go
on meanwhile."""

from __future__ import annotations

import ctypes
import re
import signal
import sys
import threading
from typing import Any

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

from . import SkylineFilters, _threads, _warnings

# Filters/PythonUpdate.cxx; ctypes sets Python's lock free around it.
_update = ctypes.CDLL(SkylineFilters.__file__).SkylineUpdateAlgorithm
_update.argtypes = [ctypes.c_void_p]
_update.restype = None

# An observer may start a run of its own.
_one_at_a_time = threading.RLock()


class Error(RuntimeError):
    """What a class of Skyline or VTK reported, in its own words."""


def _reason(text: str) -> str:
    """The message without the place in the source and the object's address."""
    lines = text.strip().split("\n")
    if lines[0].startswith(("ERROR: In ", "Warning: In ", "Generic Warning: In ")):
        lines = lines[1:]
    text = re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", " ".join(lines).strip())
    # The options that let a file be read, as arguments.
    text = re.sub(r"--driver (\w+)", r"drivers=['\1']", text)
    return re.sub(r"--allow-(network|elsewhere)", r"allow_\1=True", text)


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


def _address(algorithm: vtkAlgorithm) -> int:
    """Where the C++ object lies: its Python object tells it as _0123456789abcdef_p_vtkClass."""
    return int(algorithm.__this__.split("_")[1], 16)


def _needs_no_python(algorithm: vtkAlgorithm) -> bool:
    """True for classes that run no Python but observers; VTK's own may (vtkPythonAlgorithm)."""
    if isinstance(algorithm, vtkTrivialProducer):
        return True
    return any(base.__module__.startswith("skyline.") for base in type(algorithm).__mro__)


class _Stopper:
    """Ends a run by the first exception of its observers and of handlers of signals.

    VTK prints what an observer raises and goes on (by sys.excepthook, which is watched here), and ends
    the program for a KeyboardInterrupt; so signals, whose handlers Python calls when an observer begins,
    are handled where nothing escapes. The algorithms are asked to stop, and the exception is raised when
    they have.
    """

    def __init__(self, algorithms: list[vtkAlgorithm]) -> None:
        self.algorithms = algorithms
        self.caught: list[BaseException] = []
        self.thread = threading.get_ident()
        self.handlers: dict[int, Any] = {}

    def stop(self, reason: BaseException) -> None:
        self.caught.append(reason)
        for algorithm in self.algorithms:
            algorithm.SetAbortExecute(1)

    def hook(self, kind: Any, value: BaseException, trace: Any) -> None:
        if threading.get_ident() == self.thread:
            self.stop(value)
        else:
            self.before(kind, value, trace)

    def handle(self, number: int, frame: Any) -> None:
        try:
            self.handlers[number](number, frame)
        except BaseException as reason:
            self.stop(reason)

    def __enter__(self) -> None:
        self.before = sys.excepthook
        sys.excepthook = self.watch = self.hook
        if threading.current_thread() is threading.main_thread():
            for number in signal.valid_signals():
                handler = signal.getsignal(number)
                if callable(handler):
                    self.handlers[number] = handler
                    signal.signal(number, self.handle)
        # Python looks for signals when it runs, and in the midst of VTK that is here.
        self.tags = [
            one.AddObserver("ProgressEvent", lambda caller, event: None) for one in self.algorithms]

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        for algorithm, tag in zip(self.algorithms, self.tags):
            algorithm.RemoveObserver(tag)
        for number, handler in self.handlers.items():
            signal.signal(number, handler)
        if sys.excepthook is self.watch:
            sys.excepthook = self.before
        if self.caught:
            for algorithm in self.algorithms:
                algorithm.SetAbortExecute(0)
                algorithm.Modified()  # what was stopped has no result
            raise self.caught[0]


class reported:
    """Raises the first error that the objects report in the block, in place of printing it; without
    an error, their warnings become UserWarnings."""

    def __init__(self, *speakers: Any) -> None:
        self.reasons: list[str] = []
        self.doubts: list[str] = []

        def note(caller: Any, event: str, text: str) -> None:
            (self.reasons if event == "ErrorEvent" else self.doubts).append(_reason(text))

        note.CallDataType = "string0"  # type: ignore[attr-defined]
        self.note = note
        self.speakers = speakers

    def __enter__(self) -> None:
        events = ("ErrorEvent", "WarningEvent")
        self.tags = [(speaker, speaker.AddObserver(event, self.note))
                     for speaker in self.speakers for event in events]

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        for speaker, tag in self.tags:
            speaker.RemoveObserver(tag)
        if value is not None:
            return
        if not self.reasons:
            for text in dict.fromkeys(self.doubts):
                _warnings.warn(text)
        else:
            if "bad_alloc" in self.reasons[0]:
                raise MemoryError("not enough memory; take fewer azimuths or posts")
            raise Error(self.reasons[0])


def run(algorithm: vtkAlgorithm, call: Any = None) -> None:
    """Updates the algorithm, or makes the call that does; raises Error with what is reported.

    Other threads of Python run meanwhile, unless a call is given or some of the pipeline's classes may
    need Python. Runs of several threads wait for each other: each takes all processors.
    """
    algorithms = _pipeline(algorithm)
    speakers = algorithms + [one.GetExecutive() for one in algorithms]
    with _one_at_a_time, reported(*speakers), _Stopper(algorithms):
        _threads.prepare()
        if call:
            call()
        elif all(map(_needs_no_python, algorithms)):
            _update(_address(algorithm))
        else:
            algorithm.Update()


def update(algorithm: vtkAlgorithm) -> None:
    """Updates a pipeline of VTK classes: an error of any of them is raised, Ctrl-C stops it.

    algorithm   the pipeline's end, for which Update() would print errors and could not be stopped

    An exception of an observer stops the run and is raised, too. (VTK itself ends the program where an
    observer raises KeyboardInterrupt or SystemExit.) Other threads of Python run meanwhile; calls of
    Skyline by several threads wait for each other.

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
