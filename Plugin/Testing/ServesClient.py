# SPDX-License-Identifier: BSD-3-Clause
"""A client of a server on this machine, of one rank and of three: the server draws, and the client has the picture that it
would draw itself.
"""

import socket
import subprocess
import sys
import threading

from Support import *


def start_server(ranks):
    """The server, and the port at which it accepts connections."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [os.environ["EXABRICKS_PVSERVER"], f"--server-port={port}", "--force-offscreen-rendering"]
    if ranks > 1:
        command = [os.environ["EXABRICKS_MPIEXEC"], "-n", str(ranks), *command]
    environment = environment_of_ranks()
    environment.pop("EXABRICKS_DEVICE", None)
    server = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
    accepts = threading.Event()

    def listen():
        for line in server.stdout:
            print("server:", line, end="", flush=True)
            if "Accepting connection" in line:
                accepts.set()

    threading.Thread(target=listen, daemon=True).start()
    if not accepts.wait(timeout=200.0):
        server.kill()
        raise AssertionError("waited 200 s for the server to accept connections")
    return server, port


def look_from_client(port, local):
    # The client has no device: what it shows must be the server's.
    os.environ["EXABRICKS_DEVICE"] = "abacus"
    simple.Connect("127.0.0.1", port)
    load_plugin(remote=True)
    load_plugin()
    simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0
    scene = make_scene()
    view = make_view()
    display = show(scene, view)
    look_at(scene, view)
    expect_alike(picture(view, "remote"), local, 50.0, "client of a server")
    line = statistics(display)
    print(line)
    assert "leaf cells" in line and "active" in line, line

    # The volume is drawn on the server also where little data would go to the client.
    simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 1000
    expect_alike(picture(view, "threshold"), local, 50.0, "below the threshold of remote rendering")

    # The cells come to the client.
    cells = simple.ExaBricksCells(Input=scene)
    cells.UpdatePipeline()
    assert cells.GetDataInformation().GetNumberOfCells() > 0
    simple.Disconnect()


# The picture of one process.
load_plugin()
scene = make_scene()
view = make_view()
display = show(scene, view)
look_at(scene, view)
local = picture(view, "local")
simple.ResetSession()

ranks = int(sys.argv[1]) if len(sys.argv) > 1 else 1
server, port = start_server(ranks)
try:
    look_from_client(port, local)
finally:
    server.terminate()  # mpiexec ends its ranks
    try:
        server.wait(timeout=30.0)
    except subprocess.TimeoutExpired:
        server.kill()
