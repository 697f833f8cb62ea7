"""For scripts that start rviz or the node: programs that end with the script, and a display and a ROS master that nobody else uses."""
import contextlib
import os
import signal
import socket
import subprocess

PATIENCE = 15  # [s] for a program to end by itself


class Failure(Exception):
    """Why a script cannot do what it is for."""


@contextlib.contextmanager
def started(command, **options):
    """A process group that ends with the block: by SIGINT, and if need be by harder signals."""
    process = subprocess.Popen(command, start_new_session=True, **options)
    try:
        yield process
    finally:
        for sign in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, sign)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(PATIENCE)
                break


@contextlib.contextmanager
def display(width, height):
    """The name of a virtual display that nobody else uses."""
    read_end, write_end = os.pipe()
    command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-wr", "-nolisten", "tcp"]
    with started(command, pass_fds=[write_end], stderr=subprocess.DEVNULL):
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Failure("Xvfb found no free display")
        yield ":" + number


def take_port(home):
    """The port, as text, for a master that is still to be started. From here on this process and those that it starts use it, and ROS
    writes below the folder `home`."""
    with socket.socket() as listener:
        listener.bind(("localhost", 0))
        port = str(listener.getsockname()[1])
    os.environ.update(ROS_MASTER_URI=f"http://localhost:{port}", ROS_HOSTNAME="localhost", ROS_HOME=home, ROS_LOG_DIR=home)
    return port
