# SPDX-License-Identifier: BSD-3-Clause
"""Runs a VTK algorithm.

Errors of the algorithm and of its observers become exceptions, Ctrl-C stops it, and other Python
threads run in the meantime.
"""

from __future__ import annotations

import ctypes
import re
import signal
import sys
import threading
from typing import Any

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

from . import SkylineFilters, _threads, _warnings

# Defined in Filters/PythonUpdate.cxx; ctypes releases Python's global lock during the call.
_update = ctypes.CDLL(SkylineFilters.__file__).SkylineUpdateAlgorithm
_update.argtypes = [ctypes.c_void_p]
_update.restype = None

# Reentrant, since an observer may start another run.
_one_at_a_time = threading.RLock()


class Error(RuntimeError):
    """An error that a class of Skyline or VTK reported, with its message."""


def _reason(text: str) -> str:
    """The message without the position in VTK's source and the address of the object."""
    lines = text.strip().split("\n")
    if lines[0].startswith(("ERROR: In ", "Warning: In ", "Generic Warning: In ")):
        lines = lines[1:]
    text = re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", " ".join(lines).strip())
    # Options of the command line that allow a file to be read become arguments.
    text = re.sub(r"--driver (\w+)", r"drivers=['\1']", text)
    return re.sub(r"--allow-(network|elsewhere)", r"allow_\1=True", text)


def _pipeline(algorithm: vtkAlgorithm) -> list[vtkAlgorithm]:
    """The algorithm and all algorithms from which it gets its input."""
    found = [algorithm]
    for part in found:  # grows in the loop
        for port in range(part.GetNumberOfInputPorts()):
            for connection in range(part.GetNumberOfInputConnections(port)):
                source = part.GetInputAlgorithm(port, connection)
                if source is not None and source not in found:
                    found.append(source)
    return found


def _address(algorithm: vtkAlgorithm) -> int:
    """The address of the C++ object; in Python it has the form _0123456789abcdef_p_vtkClass."""
    return int(algorithm.__this__.split("_")[1], 16)


def _needs_no_python(algorithm: vtkAlgorithm) -> bool:
    """True for classes that run no Python but observers; VTK's own may (vtkPythonAlgorithm)."""
    if isinstance(algorithm, vtkTrivialProducer):
        return True
    return any(base.__module__.startswith("skyline.") for base in type(algorithm).__mro__)


class _Stopper:
    """Stops a run at the first exception of an observer or of a signal handler.

    VTK prints an exception of an observer with sys.excepthook and continues, and it ends the
    program at a KeyboardInterrupt. Therefore sys.excepthook is replaced here, and signals are
    handled where no exception can escape; Python calls their handlers when an observer begins. The
    algorithms are asked to stop, and the exception is raised after they have stopped.
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
        # Python handles signals only while it runs; during an update that is in this observer.
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
                algorithm.Modified()  # a stopped algorithm has no result
            raise self.caught[0]


class reported:
    """Raises the first error that the objects report in the block, instead of printing it.

    Without an error, their warnings become UserWarnings.
    """

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
                raise MemoryError("not enough memory; use fewer azimuths or posts")
            raise Error(self.reasons[0])


def run(algorithm: vtkAlgorithm, call: Any = None) -> None:
    """Updates the algorithm, or calls `call`, which updates it; raises reported errors as Error.

    Other Python threads run in the meantime, unless `call` is given or a class in the pipeline may
    need Python. Runs of several threads wait for each other, since each uses all processors.
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
    """Update a pipeline of VTK classes. Its errors are raised as exceptions, and Ctrl-C stops it.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        The end of the pipeline. Its method Update() would print errors and could not be stopped.

    Raises
    ------
    skyline.Error
        A class in the pipeline reported an error.
    UserWarning
        As a warning, for doubtful input.

    Notes
    -----
    An exception in an observer stops the run and is raised as well. (VTK itself ends the program if
    an observer raises KeyboardInterrupt or SystemExit.) Other Python threads run in the meantime;
    calls of Skyline from several threads wait for each other.

    Examples
    --------
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
