"""Starts Snakemake on the jobs of a batch, here or on a cluster, and shuts it down cleanly."""
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import time

import worker
from files import sha256, write_json
from inputs import Failure

HERE = pathlib.Path(__file__).resolve().parent
PATIENCE = 30  # [s] for jobs that are told to end
ANY_NUMBER = 1000  # of jobs in a cluster's queue, where the user does not say
SUBMIT = ("sbatch --parsable --job-name={params.name} --cpus-per-task={threads} --mem={resources.mem_mb} --time={resources.runtime} "
          "--output=slurm-%j.log --requeue")


def find():
    return shutil.which("snakemake")


def name_of(output):
    """Of the jobs of a batch in a cluster's queue."""
    return "batch-" + sha256(str(output))[:10]


def memory_here():
    """[MB]"""
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // worker.MEGABYTE


def at_once(cluster, jobs):
    """How many jobs at most."""
    return jobs or (len(os.sched_getaffinity(0)) if cluster == "local" else ANY_NUMBER)


def check(cluster):
    """A profile that Snakemake would not find."""
    if cluster in ("local", "slurm") or os.path.isdir(cluster):
        return
    places = [os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config"), "/etc/xdg"]
    if not any(os.path.isdir(os.path.join(place, "snakemake", cluster)) for place in places):
        raise Failure(f"--cluster '{cluster}': there is no folder of that name, here or in {' or '.join(os.path.join(p, 'snakemake') for p in places)}; "
                      "use local, slurm, or a folder with a config.yaml")


def arguments_of(cluster, jobs):
    """What makes Snakemake run jobs in that place."""
    number = ["--jobs", str(at_once(cluster, jobs))]
    if cluster == "local":
        return [*number, "--resources", f"mem_mb={memory_here() * 9 // 10}"]
    if cluster != "slurm":
        return ["--profile", str(pathlib.Path(cluster).resolve() if os.path.isdir(cluster) else cluster), *number]
    return ["--cluster", SUBMIT, "--cluster-status", f"sh {shlex.quote(str(HERE / 'slurm_status'))}", "--cluster-cancel", "scancel", "--latency-wait", "30", *number]


def cancel_slurm_jobs(name):
    """Jobs of a batch that was killed go on in the queue: they end before theirs are done again."""
    if not shutil.which("scancel"):
        raise Failure("--cluster slurm: there is no scancel here; start the batch where jobs are submitted (Debian: slurm-client)")
    subprocess.run(["scancel", "--name", name], check=False)
    end = time.monotonic() + PATIENCE
    while subprocess.run(["squeue", "--noheader", "--name", name], capture_output=True, text=True, check=False).stdout.strip():
        if time.monotonic() > end:
            raise Failure(f"jobs of an earlier start are still in Slurm's queue: squeue --name {name}")
        time.sleep(0.5)


def start(settings, jobs, batch, cluster, number):
    """The process of Snakemake, which leads a group of its own."""
    state = pathlib.Path(settings["state"])
    if cluster == "slurm":
        cancel_slurm_jobs(settings["name"])
    for folder in ("done", "snakemake"):
        shutil.rmtree(state / folder, ignore_errors=True)
    (state / "snakemake").mkdir(exist_ok=True)
    write_json(state / "workflow.json", {**settings, "jobs": jobs, "batch": batch})
    words = [find(), "--snakefile", str(HERE / "Snakefile"), "--configfile", str(state / "workflow.json"), "--directory", str(state / "snakemake"),
             "--nolock", "--keep-going", "--rerun-triggers", "mtime", "--forcerun", "merge", *arguments_of(cluster, number)]

    def prepare():
        os.setsid()
        worker.die_with_parent(signal.SIGKILL)

    with open(state / "snakemake.log", "wb") as log:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT, preexec_fn=prepare)


def stop(process, settings, cluster):
    """Ends the workflow and its jobs."""
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    if cluster == "slurm":
        cancel_slurm_jobs(settings["name"])
