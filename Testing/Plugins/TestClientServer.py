# SPDX-License-Identifier: BSD-3-Clause
"""A client, and a server of two processes: either can draw the picture of Soft Shadow Surface."""
import os
import socket
import subprocess
import sys
import time

import numpy as np
from paraview import simple

BIN = os.environ["SKYLINE_PARAVIEW_BIN"]


def start_server(log):
    """A server of two processes on a free port."""
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    command = [os.environ["SKYLINE_MPIEXEC"], "--oversubscribe", "-np", "2", f"{BIN}/pvserver",
               f"--server-port={port}"]
    # This process uses MPI, whose environment variables would make mpirun treat the server as a
    # child process.
    marks = ("PMIX_", "PMI_", "OMPI_", "OPAL_", "ORTE_")
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(marks) or name.startswith("OMPI_ALLOW_RUN_AS_ROOT")}
    server = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, env=environment)
    for _ in range(1200):
        if "Accepting connection" in open(log.name, encoding="utf-8").read():
            return server, port
        if server.poll() is not None:
            break
        time.sleep(0.1)
    server.kill()
    sys.exit("no server: " + open(log.name, encoding="utf-8").read())


log = open(sys.argv[3] + "/pvserver.log", "w", encoding="utf-8")
server, port = start_server(log)
simple.Connect("localhost", port)

from PluginTesting import DEM, OUTPUT, PLUGIN, expect, filters, main  # loads the plugin into the client
from SurfaceTesting import make_view, morning, picture, show_plainly

simple.LoadPlugin(PLUGIN, remote=True, ns=filters)
SERIAL = np.load(OUTPUT + "/above.npz")["codes"]
rows, columns, _ = SERIAL.shape


def test_above():
    """From above it is the serial picture, drawn by the server and by the client"""
    light = morning(filters, filters["HeightFieldReader"](FileName=DEM))
    light.UpdatePipeline()
    view = make_view([columns, rows])
    show_plainly(light, view)
    for threshold, name in ((0.0, "server"), (1e9, "client")):
        view.RemoteRenderThreshold = threshold
        found = picture(view, f"above-by-{name}")
        difference = np.abs(found.astype(int) - SERIAL)[2:-2, 2:-2]
        print(f"by the {name}: greatest difference {difference.max()} codes", flush=True)
        # ParaView compresses the pictures of a server with fewer bits.
        expect(difference.max() <= (8 if name == "server" else 1), f"by the {name}: another picture")
    simple.Delete(view)


def test_dead_light():
    """Without light nothing is drawn by either"""
    dem = filters["HeightFieldReader"](FileName=DEM)
    dem.UpdatePipeline()
    view = make_view([columns, rows])
    show_plainly(dem, view)
    for threshold in (0.0, 1e9):
        view.RemoteRenderThreshold = threshold
        expect(np.ptp(picture(view, "dark-by-either")[2:-2, 2:-2]) == 0, "nothing is drawn")


def stop():
    """The server is stopped"""
    server.terminate()
    expect(server.wait(timeout=60) is not None, "the server is gone")


main(test_above, test_dead_light, stop)
