"""Attacks on what the programs write: damaged caches, signals, a full disk. Standard library only."""
import os
import shutil
import signal
import time

import hostile_meshes as hostile
from arena import PACKAGE, QUICK, digests, name_of, report_of, robot_of_three, strangers


def truncate(rng, entries):
    file = rng.choice(entries)
    file.write_bytes(file.read_bytes()[:rng.randrange(file.stat().st_size)])


def flip_bit(rng, entries):
    file = rng.choice(entries)
    file.write_bytes(hostile.flip_bits(rng, "", file.read_bytes()))


def extend(rng, entries):
    file = rng.choice(entries)
    file.write_bytes(file.read_bytes() + file.read_bytes()[-64:])


def swap(rng, entries):
    one, other = rng.sample([entry for entry in entries if entry.suffix == ".mesh"], 2)
    shutil.copyfile(one, other)


def link_elsewhere(rng, entries):
    file = rng.choice(entries)
    moved = file.with_name("moved")
    file.rename(moved)
    file.symlink_to(moved)


def make_fifo(rng, entries):
    file = rng.choice(entries)
    file.unlink()
    os.mkfifo(file)


def open_to_all(rng, entries):
    rng.choice(entries).chmod(0o666)


def open_folder(rng, entries):
    entries[0].parent.chmod(0o777)


def change_key(rng, entries):
    entries[0].with_name("key").write_bytes(rng.getrandbits(256).to_bytes(32, "little"))


def shorten_key(rng, entries):
    entries[0].with_name("key").write_bytes(b"key")


def show_key(rng, entries):
    entries[0].with_name("key").chmod(0o644)


def give_away(rng, entries):
    if os.geteuid() == 0:  # nobody else can
        shutil.chown(entries[0].parent, 65534)
    else:
        open_folder(rng, entries)


CACHE_DAMAGES = [truncate, truncate, flip_bit, flip_bit, flip_bit, extend, swap, swap, link_elsewhere, make_fifo, open_to_all, open_folder,
                 change_key, shorten_key, show_key, give_away]


def attack_cache(arena, rng):
    """Damaged and foreign entries: the output is that of a run without a cache, and a note says why."""
    robot, good, fresh = robot_of_three(arena, "cache"), arena.work / "good_cache", arena.work / "cache_fresh"
    arguments = (robot, "--package-name", "hulls", "--quiet", "-t", "5%", "-o")
    arena.run("decompose", *arguments, fresh)
    arena.run("decompose", *arguments, arena.work / "cache_out", cache=good)
    for damage in CACHE_DAMAGES:
        cache, output = arena.work / "damaged_cache", arena.work / "cache_out"
        shutil.rmtree(cache, ignore_errors=True)
        shutil.copytree(good, cache)
        damage(rng, sorted(each for each in cache.iterdir() if each.name not in ("key", ".trimmed")))
        shutil.rmtree(output, ignore_errors=True)
        run = arena.run("decompose", *arguments, output, cache=cache)
        arena.expect(digests(output) == digests(fresh), f"another output than without a cache after {damage.__name__}: {run.command}")
        if output.is_dir():
            arena.expect(any(str(cache) in note for note in report_of(output)["notes"]), f"no note of {damage.__name__}: {run.command}")
    return f"{len(CACHE_DAMAGES)} damages"


def wait_for_moment(rng, process, output, duration):
    """Until some time after the start of a run, or after it began to write; returns when that was."""
    if rng.random() < .5:
        delay = rng.uniform(0, 1.2 * duration)
        time.sleep(delay)
        return f"{delay:.3f} s"
    while process.poll() is None and not strangers(output):
        time.sleep(.0002)
    delay = rng.uniform(0, .01)
    time.sleep(delay)
    return f"{delay:.4f} s of writing"


def check_after_signal(arena, kind, run, output, old, new, what):
    """An interrupted run leaves the old output, a finished one the new one, a killed one either, and perhaps a hidden folder."""
    left = digests(output)
    arena.expect(left in {0: [new], 130: [old]}.get(run.status, [old, new]), f"exit status {run.status}, but another output after {what}")
    beside = [name for name in strangers(output) if kind != signal.SIGKILL or not name.startswith(".collision_hulls-")]
    arena.expect(not beside, f"{beside} beside the output after {what}")


def interrupt(arena, rng, kind, command, output, old, new, duration):
    """Sends a signal to a run, and runs again; whether the signal left the old output."""
    cache = arena.folder("signals_cache")
    process = arena.start(*command, cache=cache)
    what = f"{name_of(kind)} after {wait_for_moment(rng, process, output, duration)}"
    process.send_signal(kind)
    run = arena.ended(process)
    arena.expect(run.status in (0, 130, -kind), f"exit status {run.status} after {what}: {run.command}\n{run.errors[:2000]}")
    check_after_signal(arena, kind, run, output, old, new, what)
    stayed = digests(output) == old
    run = arena.run(*command, cache=cache)
    arena.expect(run.status == 0 and digests(output) == new, f"the run after {what} fails: {run.command}\n{run.errors[:2000]}")
    arena.expect(not strangers(output), f"{strangers(output)} beside the output after {what} and another run")
    return stayed


def attack_signals(arena, rng):
    """Signals at any moment of a run that replaces an output: the old or the new one is there, nothing else, and the next run works."""
    robot, output = robot_of_three(arena, "signals"), arena.folder("signals_out") / "hulls"
    kept, fresh = arena.work / "signals_old", arena.work / "signals_new"
    command = ("decompose", robot, "--package-name", "hulls", "--quiet")
    arena.run(*command, "-t", "5%", "-o", kept)
    began = time.monotonic()
    arena.run(*command, "-t", "1%", "-o", fresh)
    duration = time.monotonic() - began
    old, new = digests(kept), digests(fresh)
    arena.expect(old != new, "both tolerances give the same output, so nothing can be told")
    stayed = []
    for kind in 8 * [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]:
        shutil.rmtree(output, ignore_errors=True)
        shutil.copytree(kept, output)
        stayed.append(interrupt(arena, rng, kind, (*command, "-t", "1%", "-o", output), output, old, new, duration))
    return f"{len(stayed)} signals, {sum(stayed)} of which left the old output"


def attack_full_disk(arena, rng):
    """Files that cannot grow, as on a full disk: the earlier output stays."""
    robot, output = robot_of_three(arena, "disk"), arena.folder("disk_out") / "hulls"
    old = arena.work / "disk_old"
    arena.run("decompose", robot, "--package-name", "hulls", *QUICK, "-o", old)
    before = digests(old)
    scene = ("--scene", PACKAGE / "test/data/scenes/table.yaml", "--clearance", "2cm", "--samples", "100")
    limits = [("decompose", size, ()) for size in (0, 1, 84, 500, 1500, 4096, 10**6)]
    limits += [("fit_scene", size, scene) for size in (0, 1500, 10**6)]
    for program, file_bytes, options in limits:
        shutil.rmtree(output, ignore_errors=True)
        shutil.copytree(old, output)
        cache = arena.folder("disk_cache")
        run = arena.run(program, robot, "-o", output, "--no-validate", "--quiet", "-t", "1%", *options, file_bytes=file_bytes, cache=cache)
        wanted = 0 if file_bytes == 10**6 else 2
        arena.expect(run.status == wanted, f"a limit of {file_bytes} bytes ends with {run.status}: {run.command}\n{run.errors[:2000]}")
        arena.expect(run.status == 0 or digests(output) == before, f"a limit of {file_bytes} bytes harms the earlier output: {run.command}")
        arena.expect(not strangers(output), f"{strangers(output)} beside the output: {run.command}")
    return f"{len(limits)} limits"
