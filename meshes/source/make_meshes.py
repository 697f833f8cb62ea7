#!/usr/bin/env python3
"""Renders the parts of the demo robot with OpenSCAD and writes them in the robot's mixture of formats, units and up-axes.

usage: make_meshes.py [FOLDER]        default: the folder above this one
"""
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import mesh_files
from mesh_files import Material, Node, scaled, y_up

SOURCE = pathlib.Path(__file__).resolve().parent
MM = 0.001  # in metres

GRAPHITE = Material("graphite", (0.30, 0.33, 0.37))
ORANGE = Material("orange", (0.93, 0.47, 0.10))
STEEL = Material("steel", (0.72, 0.74, 0.77))

PARTS = ["base", "shoulder_fork", "upper_arm", "upper_arm_collision", "elbow_bracket", "motor_housing", "forearm", "wrist", "flange",
         "gripper_housing", "gripper_rail", "finger"]
DRAWN_BY = {"upper_arm_collision": ["-D", "coarse=true", "upper_arm.scad"]}


def draw(part):
    """The part as a mesh in millimetres."""
    with tempfile.TemporaryDirectory() as folder:
        off = pathlib.Path(folder) / "part.off"
        command = ["openscad", "--quiet", "-o", str(off), *DRAWN_BY.get(part, [part + ".scad"])]
        run = subprocess.run(command, cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        if run.returncode or run.stdout:
            raise RuntimeError(f"{' '.join(command)} said:\n{run.stdout}")
        mesh = mesh_files.read_off(off.read_text())
    mesh_files.check_solid(part, mesh)
    return mesh


def write(part, folder):
    for name in ("upper_arm", "upper_arm_collision", "forearm", "wrist", "flange", "finger"):
        mesh_files.write_stl(folder / f"{name}.stl", part[name])
    mesh_files.write_stl(folder / "motor_housing.stl", scaled(part["motor_housing"], MM))

    mesh_files.write_mtl(folder / "demo_arm.mtl", [ORANGE])
    mesh_files.write_obj(folder / "shoulder_fork.obj", part["shoulder_fork"], ORANGE, "demo_arm.mtl")
    mesh_files.write_obj(folder / "elbow_bracket.obj", scaled(part["elbow_bracket"], MM), ORANGE, "demo_arm.mtl")

    base = ("base", scaled(part["base"], MM))
    mesh_files.write_dae(folder / "base.dae", "Z_UP", "meter", 1, [Node("base", base, GRAPHITE, "")])

    housing = ("housing", y_up(scaled(part["gripper_housing"], 0.1)))
    rail = ("rail", y_up(scaled(part["gripper_rail"], 0.1)))
    mesh_files.write_dae(folder / "gripper.dae", "Y_UP", "centimeter", 0.01, [
        Node("housing", housing, GRAPHITE, "<matrix>1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1</matrix>"),
        Node("upper_rail", rail, STEEL, "<translate>3.2 1.3 0</translate><rotate>0 1 0 90</rotate>"),
        Node("lower_rail", rail, STEEL, "<translate>3.2 -1.3 0</translate><rotate>0 1 0 90</rotate>"),
    ])


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE.parent
    folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor() as pool:
        meshes = dict(zip(PARTS, pool.map(draw, PARTS)))
    write(meshes, folder)


if __name__ == "__main__":
    main()
