#!/usr/bin/python3
"""The panel in rviz, with the demo robot, driven by keys and clicks: what it shows, changes, saves and remembers.

Tests src/panel/hulls_panel.cpp, src/panel/node_client.cpp, src/panel/panel_actions.cpp, src/panel/settings_form.cpp and src/panel/table_model.cpp.
"""
import contextlib
import filecmp
import importlib.machinery
import importlib.util
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest

import rostest

WIDTH, HEIGHT = 1500, 900
PROGRAMS = ("Xvfb", "convert")
PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
CONFIG = os.path.join(PACKAGE, "rviz", "collision_hulls.rviz")
ROBOT = os.path.join(PACKAGE, "urdf", "demo_arm.urdf")
SPACE = os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0]  # devel
DRIVER = os.path.join(os.path.dirname(SPACE), "tests", "panel_driver")
METHOD, TOLERANCE, HULLS, PROVED, STATUS = 1, 2, 3, 6, 7  # columns


def load_script(name):
    loader = importlib.machinery.SourceFileLoader(name, os.path.join(PACKAGE, "scripts", name))
    script = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(script)
    return script


def changed_pixels(before, after):
    """How many, in the middle of the window, where the robot is."""
    command = ["convert", before, after, "-crop", "480x700+360+100", "-compose", "difference", "-composite", "-threshold", "5%", "-format", "%[fx:mean*w*h]", "info:"]
    return float(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)


class PanelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        missing = [program for program in PROGRAMS if shutil.which(program) is None] + ([] if os.path.exists(DRIVER) else [DRIVER])
        if missing:
            raise unittest.SkipTest("no panel without " + ", ".join(missing))
        # As in a shell that has sourced setup.bash: tests have the source folder on the path instead.
        os.environ["ROS_PACKAGE_PATH"] = SPACE + "/share"
        cls.script = load_script("panel_picture")
        cls.stack = contextlib.ExitStack()
        cls.addClassCleanup(cls.stack.close)
        cls.home = cls.stack.enter_context(tempfile.TemporaryDirectory(prefix="collision_hulls_test_"))
        os.environ["COLLISION_HULLS_CACHE"] = cls.file("cache")
        log = cls.stack.enter_context(open(cls.file("log"), "w", encoding="utf-8"))
        cls.stack.enter_context(cls.script.demo_robot(cls.home, log))
        cls.rviz = cls.stack.enter_context(cls.script.driven_rviz(DRIVER, CONFIG, WIDTH, HEIGHT))
        cls.rviz.wait("totals", "text", "^9 links", cls.script.WAIT)
        cls.settle()
        cls.rviz("click", "build")
        cls.rviz.wait("cancel", "enabled", "true")
        cls.settle()

    @classmethod
    def file(cls, name):
        return os.path.join(cls.home, name)

    @classmethod
    def settle(cls, rviz=None):
        """Until the last change is certified."""
        time.sleep(1)
        (rviz or cls.rviz).wait_until_idle()

    def slide(self, link, keys, times):
        self.rviz("choose", link)
        self.rviz("key", "tolerance", keys, times)
        self.settle()
        return self.rviz.rows()[link]

    def test_all_links_have_hulls_and_a_bound(self):
        rows = self.rviz.rows()
        self.assertEqual(9, len(rows))
        for row in rows.values():
            self.assertRegex(row[PROVED], r"^[\d.]+ mm$", row)
        self.assertRegex(self.rviz("get", "totals", "text"), r"\d+ hulls.*at most <b>[\d.]+ mm")

    def test_a_coarser_tolerance_has_fewer_hulls_and_another_picture(self):
        self.rviz("choose", "shoulder_link")
        before = int(self.rviz.rows()["shoulder_link"][HULLS])
        self.rviz("picture", self.file("before.png"))
        after = int(self.slide("shoulder_link", "Right", 12)[HULLS])
        self.rviz("picture", self.file("after.png"))
        self.assertLess(after, before)
        self.assertRegex(self.rviz("get", "effect", "text"), f"<b>{after}</b> hulls?, proved to protrude at most")
        self.assertGreater(changed_pixels(self.file("before.png"), self.file("after.png")), 200)
        self.rviz("click", "undo")
        self.settle()
        self.assertEqual(before, int(self.rviz.rows()["shoulder_link"][HULLS]))

    def test_each_step_of_the_slider_changes_the_number_of_hulls(self):
        self.rviz("choose", "forearm_link")
        counts = []
        for _ in range(5):
            counts.append(int(self.slide("forearm_link", "Left", 1)[HULLS]))
        self.assertEqual(counts, sorted(set(counts)))
        self.settle()

    def test_the_saved_file_gives_decompose_the_same_hulls(self):
        self.slide("gripper_link", "Left", 6)
        self.slide("upper_arm_link", "Right", 3)
        self.rviz("choose", "flange_link")
        self.rviz("key", "method", "b", 1)  # bounding_box
        self.rviz("choose", "left_finger_link")
        self.rviz("key", "action", "k", 1)  # keep
        self.settle()
        self.settle()  # each change ends the build before, which then begins once more
        rows = self.rviz.rows()
        self.assertEqual(["bounding_box", "keep"], [rows[link][METHOD] for link in ("flange_link", "left_finger_link")])
        self.rviz("file", self.file("saved.yaml"))
        self.rviz("click", "save")
        self.rviz.wait("message", "text", "^Saved ")
        self.rviz("click", "write")
        self.rviz.wait("message", "text", " hulls for ", self.script.WAIT)
        subprocess.run([os.path.join(SPACE, "lib", "collision_hulls", "decompose"), ROBOT, "--config", self.file("saved.yaml"), "--no-cache",
                        "--no-validate", "-o", self.file("same")], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(self.file("same/report.json"), encoding="utf-8") as report:
            elements = json.load(report)["links"]
        for link, row in rows.items():
            hulls = sum(element["hulls"] for element in elements if element["link"] == link)
            self.assertEqual("–" if link == "left_finger_link" else str(hulls), row[HULLS], link)
        comparison = filecmp.dircmp(self.file("written/meshes"), self.file("same/meshes"))
        for folder, part in [("", comparison), *comparison.subdirs.items()]:
            self.assertEqual([[], [], []], [part.left_only, part.right_only, part.diff_files], folder)

    def test_a_bad_file_is_refused_with_its_line(self):
        before = self.rviz.rows()
        with open(self.file("bad.yaml"), "w", encoding="utf-8") as file:
            file.write("default: {tolerance: 1cm}\nlinks: {elbow: keep}\n")
        self.rviz("file", self.file("bad.yaml"))
        self.rviz("click", "load")
        self.assertIn("line 2", self.rviz.wait("message", "text", "elbow"))
        self.assertEqual(before, self.rviz.rows())

    def test_a_typed_tolerance_counts_and_a_wrong_one_says_why(self):
        self.rviz("choose", "base_link")
        self.rviz("type", "tolerance_text", "7mm")
        self.settle()
        self.assertEqual("7mm", self.rviz.rows()["base_link"][TOLERANCE])
        self.rviz("type", "tolerance_text", "seven")
        self.assertIn("seven", self.rviz("get", "effect", "text"))
        self.assertEqual("7mm", self.rviz.rows()["base_link"][TOLERANCE])

    def test_the_filter_hides_links_and_nothing_else(self):
        self.rviz("type", "filter", "FINGER")
        self.assertEqual({"left_finger_link", "right_finger_link"}, set(self.rviz.rows()))
        self.assertIn("9 links", self.rviz("get", "totals", "text"))
        self.rviz("type", "filter", "")

    def test_every_control_is_reached_by_the_tab_key(self):
        self.rviz("choose", "elbow_link")
        self.rviz("key", "node", "Tab", 1)
        reached = {self.rviz("focus", "Tab", 1) for _ in range(25)}
        self.assertLessEqual({"links", "tolerance", "tolerance_text", "action", "method", "effort", "max_hulls", "max_vertices", "source",
                              "tree", "build", "load", "save", "fit", "write"}, reached)

    def test_the_settings_survive_in_rvizs_configuration(self):
        wanted = self.slide("elbow_link", "Right", 4)[TOLERANCE]
        self.rviz("type", "filter", "elbow")
        self.rviz("config", self.file("saved.rviz"))
        self.rviz("type", "filter", "")
        with open(self.file("saved.rviz"), encoding="utf-8") as file:
            text = file.read()
        self.assertRegex(text, rf"elbow_link.*tolerance: {re.escape(wanted)}")
        with self.script.driven_rviz(DRIVER, self.file("saved.rviz"), WIDTH, HEIGHT) as other:
            other.wait("totals", "text", "^9 links")
            self.assertEqual("elbow", other("get", "filter", "text"))
            self.assertEqual(wanted, other.rows()["elbow_link"][TOLERANCE])

    def test_a_fit_to_a_scene_needs_fewer_hulls(self):
        before = sum(int(row[HULLS]) for row in self.rviz.rows().values() if row[HULLS] != "–")
        self.rviz("file", os.path.join(PACKAGE, "urdf", "demo_shelf.yaml"))
        self.rviz("click", "fit")
        self.rviz.wait("message", "text", " hulls? for ", self.script.WAIT)
        self.settle()
        self.assertLess(sum(int(row[HULLS]) for row in self.rviz.rows().values() if row[HULLS] != "–"), before)
        self.rviz("click", "build")
        self.rviz.wait("cancel", "enabled", "true")
        self.settle()

    def test_no_node_of_that_name_says_what_to_start(self):
        self.rviz("type", "node", "/left/nobody")
        advice = self.rviz.wait("advice", "text", "no node /left/nobody")
        self.assertIn("roslaunch collision_hulls", advice)
        self.assertEqual("false", self.rviz("get", "write", "enabled"))
        self.rviz("type", "node", "collision_hulls")
        self.rviz.wait("totals", "text", "^9 links")

    def test_a_node_in_another_name_space_is_found(self):
        program = os.path.join(SPACE, "lib", "collision_hulls", "collision_hulls_node")
        with self.script.started([program, "__ns:=left", "__name:=hulls", f"_output_root:={self.home}"], stdout=subprocess.DEVNULL):
            self.rviz("type", "node", "/left/hulls")
            self.rviz.wait("advice", "text", "press Build")
            self.rviz("click", "build")
            self.rviz.wait("totals", "text", "^9 links", self.script.WAIT)
        self.rviz.wait("advice", "text", "no node /left/hulls")
        self.rviz("type", "node", "collision_hulls")
        self.rviz.wait("totals", "text", "^9 links")


if __name__ == "__main__":
    rostest.rosrun("collision_hulls", "panel_test", PanelTest)
