"""Attacks on the node: hostile requests in a row, and signals at random moments. Needs ROS; where that is missing, nothing is attacked."""
import importlib.util
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time

import descriptions
import hostile_meshes as hostile
from arena import PATIENCE, description, digests, in_folder, name_of, strangers

CALLS = int(os.environ.get("ATTACK_CALLS", "60"))
MOST_GROWTH = 40  # MB, of the node's memory from a third of the calls to their end
SIGNALS = 8


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def children_of(process):
    """The ids of all processes below one."""
    below = []
    for folder in pathlib.Path(f"/proc/{process}/task").glob("*"):
        try:
            below += [int(word) for word in (folder / "children").read_text().split()]
        except OSError:  # a thread that has ended meanwhile
            pass
    return below + [grandchild for child in below for grandchild in children_of(child)]


def megabytes_of(process):
    lines = pathlib.Path(f"/proc/{process}/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024


def await_that(condition, seconds=PATIENCE):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(.02)
    return True


class Ros:
    """A master of its own, and what talks to it."""

    def __init__(self, arena):
        self.arena, self.home = arena, arena.folder("node_home")
        os.environ.update(ROS_MASTER_URI=f"http://localhost:{free_port()}", ROS_HOSTNAME="localhost", ROS_LOG_DIR=str(self.home))
        port = os.environ["ROS_MASTER_URI"].rsplit(":", 1)[1]
        self.master = subprocess.Popen(["rosmaster", "--core", "-p", port], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        sys.path.insert(0, str(arena.programs.parent / "python3/dist-packages"))
        import rosgraph
        import rospy
        from collision_hulls.srv import Decompose
        self.rospy, self.service = rospy, Decompose
        if not await_that(rosgraph.is_master_online):
            raise RuntimeError("no ROS master")
        rospy.init_node("attacks", disable_signals=True)

    def start_node(self, folder, output_root):
        """A node that may read one folder and write another."""
        arguments = [str(self.arena.programs / "collision_hulls_node"), "__name:=victim", f"_output_root:={output_root}",
                     f"_read_roots:={folder}", "_auto:=false", "_validate:=false", "_cache:=false"]
        node = subprocess.Popen(arguments, env=dict(os.environ, HOME=str(self.home), ROS_HOME=str(self.home)), cwd=self.home,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.rospy.wait_for_service("/victim/decompose", timeout=PATIENCE)
        return node

    def call(self, text, output, **fields):
        return self.rospy.ServiceProxy("/victim/decompose", self.service)(robot_description=text, output=str(output), brief=True, **fields)

    def close(self):
        self.rospy.signal_shutdown("done")
        self.master.terminate()
        self.master.wait()


def hostile_requests(rng, folder):
    """Endless (what, description), each with a good mesh and a hostile one, or hostile as a text."""
    seeds = [seed for seed in hostile.seed_meshes(pathlib.Path(__file__).resolve().parent.parent.parent / "meshes") if len(seed[1]) < 20000]
    texts = list(descriptions.hostile_texts().items())
    (folder / "good.obj").write_bytes(hostile.obj(hostile.bracket()))
    bad = list(descriptions.hostile_files(folder).values())
    while True:
        extension, content = rng.choice(seeds)
        mutated = folder / ("mutated" + extension)
        mutated.write_bytes(hostile.mutated(rng, extension, content))
        uris = {"good": folder / "good.obj", "mutated": mutated, "bad": rng.choice(bad)}
        yield "meshes", description({link: f"file://{uri}" if isinstance(uri, pathlib.Path) else uri for link, uri in uris.items()})
        yield texts[rng.randrange(len(texts))]


def attack_calls(arena, rng, ros):
    """Hostile requests: the node answers each, lives, and does not grow."""
    folder, output = arena.folder("node_input"), arena.folder("node_output")
    node = ros.start_node(folder, output)
    sizes = []
    for (what, text), _ in zip(hostile_requests(rng, folder), range(CALLS)):
        try:
            response = ros.call(text.replace("\0", " "), output / "made", method="single_hull")
            arena.expect(response.message, f"the node has nothing to say about {what}")
        except (ros.rospy.ServiceException, UnicodeError) as error:
            arena.fault(f"the node does not answer to {what}: {error}")
        if not arena.expect(node.poll() is None, f"the node dies of {what}, with {node.poll()}"):
            return
        sizes.append(megabytes_of(node.pid))
    growth = sizes[-1] - sizes[len(sizes) // 3]
    arena.expect(growth < MOST_GROWTH, f"{len(sizes)} calls make the node grow by {growth:.0f} MB: {sizes}")
    end_node(arena, node, signal.SIGINT, "when it is idle")


def end_node(arena, node, kind, when):
    """Sends a signal. The node ends in order, and so does all that it started."""
    below = children_of(node.pid)
    node.send_signal(kind)
    try:
        status = node.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        node.kill()
        status = "never"
    arena.expect(status in (0, -kind), f"after {name_of(kind)} {when} the node ends with {status}")
    left = [each for each in below if not await_that(lambda each=each: not pathlib.Path(f"/proc/{each}").exists(), 5)]
    arena.expect(not left, f"after {name_of(kind)} {when} processes remain: {left}")


def attack_signals(arena, rng, ros):
    """Signals while a request replaces an output: the old or the new output is there, whole, and nothing else."""
    folder, root = arena.folder("node_signals"), arena.folder("node_signals_output")
    meshes = {"box": (".stl", hostile.binary_stl(hostile.BOX)), "bracket": (".obj", hostile.obj(hostile.bracket()))}
    files, _ = in_folder(folder, meshes)
    text, output = description({link: f"file://{file}" for link, file in files.items()}), root / "made"
    kept = arena.work / "node_signals_old"
    for i in range(SIGNALS):
        node = ros.start_node(folder, root)
        if i == 0:
            ros.call(text, output, method="bounding_box")
            shutil.copytree(output, kept)
            ros.call(text, output)
            new = digests(output)
        shutil.rmtree(output)
        shutil.copytree(kept, output)
        call = threading.Thread(target=ignoring(ros.rospy.ServiceException, ros.call), args=(text, output))
        call.start()
        delay = rng.uniform(0, .5)
        time.sleep(delay)
        end_node(arena, node, rng.choice([signal.SIGINT, signal.SIGTERM]), f"{delay:.3f} s into a call")
        call.join()
        arena.expect(digests(output) in (digests(kept), new), f"half an output after {delay:.3f} s of a call")
        arena.expect(not strangers(output), f"{strangers(output)} beside the output after {delay:.3f} s of a call")


def ignoring(kind, function):
    def run(*arguments):
        try:
            function(*arguments)
        except kind:
            pass
    return run


def attack_node(arena, rng):
    if not (arena.programs / "collision_hulls_node").exists() or importlib.util.find_spec("rosgraph") is None:
        return "no ROS"
    ros = Ros(arena)
    try:
        attack_calls(arena, rng, ros)
        attack_signals(arena, rng, ros)
    finally:
        ros.close()
    return f"{CALLS} calls, {SIGNALS} signals"
