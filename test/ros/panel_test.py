#!/usr/bin/python3
"""The panel in rviz, with the demo robot, driven by keys and clicks: what it shows, changes, saves and remembers.

Tests src/panel/hulls_panel.cpp, src/panel/node_client.cpp, src/panel/panel_actions.cpp, src/panel/panel_regions.cpp, src/panel/region_form.cpp,
src/panel/region_markers.cpp, src/panel/region_server.cpp, src/panel/settings_form.cpp and src/panel/table_model.cpp.
"""
import contextlib
import filecmp
import importlib.machinery
import importlib.util
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import rospy
import rostest
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerInit

WIDTH, HEIGHT = 1366, 768  # of a small laptop
PROGRAMS = ("Xvfb", "convert")
PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
CONFIG = os.path.join(PACKAGE, "rviz", "collision_hulls.rviz")
ROBOT = os.path.join(PACKAGE, "urdf", "demo_arm.urdf")
SPACE = os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0]  # devel
DRIVER = os.path.join(os.path.dirname(SPACE), "tests", "panel_driver")
METHOD, TOLERANCE, HULLS, BOUND, STATUS = 1, 2, 3, 5, 7  # columns


def load_script(name):
    loader = importlib.machinery.SourceFileLoader(name, os.path.join(PACKAGE, "scripts", name))
    script = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(script)
    return script


def changed_pixels(before, after):
    """How many, in the middle of the window, where the robot is."""
    command = ["convert", before, after, "-crop", "400x560+120+100", "-compose", "difference", "-composite", "-threshold", "5%", "-format", "%[fx:mean*w*h]", "info:"]
    return float(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)


def bodies(row):
    """Hulls and primitives, as in "3 hulls and 1 primitive"."""
    return sum(int(number) for number in re.findall(r"\d+", row[HULLS]))


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
        rospy.init_node("panel_test", anonymous=True, disable_signals=True)
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
            self.assertRegex(row[BOUND], r"^[\d.]+ mm$", row)
        self.assertRegex(self.rviz("get", "totals", "text"), r"\d+ hulls.*at most <b>[\d.]+ mm")

    def test_a_coarser_tolerance_has_fewer_hulls_and_another_picture(self):
        self.rviz("choose", "shoulder_link")
        before = int(self.rviz.rows()["shoulder_link"][HULLS])
        self.rviz("picture", self.file("before.png"))
        after = int(self.slide("shoulder_link", "Right", 12)[HULLS])
        self.rviz("picture", self.file("after.png"))
        self.assertLess(after, before)
        self.assertRegex(self.rviz("get", "effect", "text"), f"<b>{after} hulls?</b>, proved to protrude at most")
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
        self.rviz("type", "filter", "base")
        self.rviz("type", "filter", "")
        self.settle()
        self.assertIn("seven", self.rviz("get", "effect", "text"))
        self.assertEqual("seven", self.rviz("get", "tolerance_text", "text"))
        self.assertEqual("7mm", self.rviz.rows()["base_link"][TOLERANCE])
        self.rviz("key", "tolerance", "Right", 1)
        self.assertRegex(self.rviz("get", "tolerance_text", "text"), r"^[\d.]+mm$")
        self.rviz("click", "undo")
        self.settle()
        self.assertEqual("7mm", self.rviz("get", "tolerance_text", "text"))

    def test_typed_openings_are_saved_and_wrong_ones_say_why(self):
        self.rviz("choose", "base_link")
        self.assertEqual("0", self.rviz("get", "close_openings", "text"))
        self.rviz("type", "close_openings", "wide")
        self.assertIn("close openings 'wide'", self.rviz("get", "effect", "text"))
        self.rviz("type", "close_openings", "5cm")
        self.settle()
        self.assertIn("close_openings: 5cm", self.saved())
        self.rviz("click", "undo")
        self.settle()
        self.assertNotIn("close_openings: 5cm", self.saved())

    def test_the_filter_hides_links_and_nothing_else(self):
        self.rviz("type", "filter", "FINGER")
        self.assertEqual({"left_finger_link", "right_finger_link"}, set(self.rviz.rows()))
        self.assertIn("9 links", self.rviz("get", "totals", "text"))
        self.rviz("type", "filter", "")

    # Regions.

    def show_form(self, name):
        """One of the two that the settings share a place with."""
        self.rviz("key", "qt_tabwidget_tabbar", {"settings": "Left", "regions": "Right"}[name], 1)

    def add_region(self, link, kind, tolerance="9mm"):
        """Such a tolerance is built in no time, wherever the region is meanwhile."""
        self.rviz("choose", link)
        self.show_form("regions")
        self.rviz("click", "add_" + kind)
        self.addCleanup(self.remove_regions, link)
        self.assertEqual("true", self.rviz("get", "keep_clear", "checked"))
        self.rviz("click", "keep_clear")
        self.rviz("type", "region_tolerance", tolerance)

    def remove_regions(self, link):
        self.rviz("choose", link)
        self.show_form("regions")
        while self.rviz("get", "remove_region", "enabled") == "true":
            self.rviz("click", "remove_region")
        self.show_form("settings")
        self.settle()

    def numbers(self, field):
        return [float(number) for number in self.rviz("get", "region_" + field, "text").split(",")]

    def numbers_at_rest(self, *fields):
        """Once two looks at all of them agree: what rviz says of a drag may still be under way."""
        before = None
        for _ in range(30):
            now = [self.numbers(field) for field in fields]
            if now == before:
                return now
            before = now
            time.sleep(1)
        self.fail("the fields %s do not come to rest" % (fields,))

    def enter(self, field, *numbers):
        self.rviz("type", "region_" + field, ", ".join(map(str, numbers)))

    def drag(self, link, start, end):
        self.rviz("drag", link, *(",".join(map(str, point)) for point in (start, end)))
        self.settle()

    def saved(self):
        """The configuration. No file is there before: the dialog would ask whether to replace it."""
        if os.path.exists(self.file("regions.yaml")):
            os.remove(self.file("regions.yaml"))
        self.rviz("file", self.file("regions.yaml"))
        self.rviz("click", "save")
        self.rviz.wait("message", "text", "^Saved ")
        with open(self.file("regions.yaml"), encoding="utf-8") as file:
            return file.read()

    def test_a_face_of_a_box_is_dragged_in_the_view(self):
        self.add_region("gripper_link", "box")
        self.enter("center", 0, 0, 0.08)
        self.enter("size", 0.1, 0.2, 0.06)
        self.settle()
        self.drag("gripper_link", (0, 0.1, 0.08), (0, 0.16, 0.08))
        size, center = self.numbers_at_rest("size", "center")
        self.assertAlmostEqual(0.26, size[1], delta=0.02)
        self.assertAlmostEqual(0.1, size[0], delta=1e-6)
        self.assertAlmostEqual(-0.1, center[1] - size[1] / 2, delta=1e-4, msg="the opposite face has moved")
        self.rviz("click", "undo")
        self.assertAlmostEqual(0.2, self.numbers("size")[1], delta=1e-6, msg="a drag is one move")
        self.rviz("picture", self.file("box.png"))
        self.remove_regions("gripper_link")
        self.rviz("picture", self.file("no_box.png"))
        self.assertGreater(changed_pixels(self.file("box.png"), self.file("no_box.png")), 200)

    def test_a_region_is_built_and_saved_and_gives_decompose_the_same_hulls(self):
        before = self.rviz.rows()["gripper_link"]
        self.add_region("gripper_link", "half_space", "3mm")
        self.enter("normal", 0, 0, 1)
        self.enter("offset", 0.05)
        self.rviz("type", "region_name", "mouth")
        self.settle()
        row = self.rviz.rows()["gripper_link"]
        self.assertNotEqual(before[HULLS], row[HULLS])
        self.assertRegex(self.saved(), r'link: "gripper_link", name: "mouth", half_space: \{normal: \[0, 0, 1\], offset: 0.05\}, tolerance: 3mm')
        self.rviz("click", "write")
        self.rviz.wait("message", "text", " hulls for ", self.script.WAIT)
        subprocess.run([os.path.join(SPACE, "lib", "collision_hulls", "decompose"), ROBOT, "--config", self.file("regions.yaml"), "--no-cache",
                        "--no-validate", "-o", self.file("in_regions")], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        comparison = filecmp.dircmp(self.file("written/meshes/gripper_link"), self.file("in_regions/meshes/gripper_link"))
        self.assertEqual([[], [], []], [comparison.left_only, comparison.right_only, comparison.diff_files])
        self.assertTrue(comparison.same_files)

    def test_a_half_space_tilts_and_a_release_puts_its_plane_back(self):
        self.add_region("gripper_link", "half_space")
        self.enter("normal", 0, 0, -1)
        self.enter("offset", 0)
        self.settle()
        topic = "/collision_hulls/regions"
        markers = rospy.wait_for_message(topic + "/update_full", InteractiveMarkerInit, 10).markers
        self.assertEqual(["gripper_link/1/whole"], [marker.name for marker in markers])
        self.assertEqual("gripper_link", markers[0].header.frame_id)
        feedback = InteractiveMarkerFeedback(client_id="test", marker_name=markers[0].name, event_type=InteractiveMarkerFeedback.POSE_UPDATE)
        feedback.header.frame_id = "gripper_link"
        feedback.pose.position.z = 0.1
        feedback.pose.orientation.w = feedback.pose.orientation.z = 0.5 ** 0.5  # its normal, the x axis, along y
        publisher = rospy.Publisher(topic + "/feedback", InteractiveMarkerFeedback, queue_size=10)
        while publisher.get_num_connections() == 0:
            rospy.sleep(0.05)
        publisher.publish(feedback)
        self.rviz.wait("region_normal", "text", "^0, 1, 0$")
        self.assertEqual([0], self.numbers("offset"))
        feedback.event_type = InteractiveMarkerFeedback.MOUSE_UP
        publisher.publish(feedback)
        self.settle()
        pose = rospy.wait_for_message(topic + "/update_full", InteractiveMarkerInit, 10).markers[0].pose
        self.assertAlmostEqual(0, pose.position.y, msg="on the plane, below the middle of the link")

    def test_a_wrong_region_says_why_and_changes_nothing(self):
        self.add_region("gripper_link", "box")
        size = self.rviz("get", "region_size", "text")
        self.rviz("type", "region_size", "1, 2")
        self.settle()
        self.assertIn("three numbers", self.rviz("get", "region_advice", "text"), "answers of the node have taken the reason away")
        self.assertEqual("1, 2", self.rviz("get", "region_size", "text"))
        self.rviz("click", "add_box")
        self.assertNotIn("three numbers", self.rviz("get", "region_advice", "text"), "of a region that is no longer shown")
        self.rviz("click", "undo")
        self.rviz("type", "region_size", "0, 1, 1")
        self.rviz.wait("message", "text", "region '1'")
        self.rviz("type", "region_size", size)
        self.assertIn("size: [" + size, self.saved())

    def test_a_link_that_is_kept_has_no_regions(self):
        self.rviz("choose", "left_finger_link")
        self.show_form("regions")
        self.assertEqual("true", self.rviz("get", "add_box", "enabled"))
        self.show_form("settings")
        self.rviz("key", "action", "k", 1)
        self.show_form("regions")
        self.assertEqual("false", self.rviz("get", "add_box", "enabled"))
        self.show_form("settings")
        self.rviz("click", "undo")
        self.settle()

    def test_a_validation_says_what_its_queries_found(self):
        self.rviz("click", "validate")
        found = self.rviz.wait("message", "text", "compared hulls and meshes", self.script.WAIT)
        self.assertRegex(found, r"^\d{3,} queries compared hulls and meshes: no collision missed, no false collision beyond the protrusion; .* mm too short$")
        self.settle()

    def test_nothing_is_cut_off_on_a_small_screen(self):
        for form in ("regions", "settings"):
            self.show_form(form)
            self.assertEqual("", self.rviz("cut"), form)

    def test_every_control_is_reached_by_the_tab_key(self):
        self.rviz("choose", "elbow_link")
        self.rviz("key", "node", "Tab", 1)
        reached = {self.rviz("focus", "Tab", 1) for _ in range(25)}
        self.assertLessEqual({"links", "tolerance", "tolerance_text", "action", "method", "effort", "max_hulls", "max_vertices", "source",
                              "close_openings", "tree", "build", "validate", "load", "save", "fit", "write"}, reached)

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
        before = sum(bodies(row) for row in self.rviz.rows().values())
        self.rviz("file", os.path.join(PACKAGE, "urdf", "demo_shelf.yaml"))
        self.rviz("click", "fit")
        self.rviz.wait("message", "text", " for [0-9]+ mesh", self.script.WAIT)
        self.settle()
        self.assertLess(sum(bodies(row) for row in self.rviz.rows().values()), before)
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

    @contextlib.contextmanager
    def built_on_the_left(self):
        """Another node, with the panel's hulls; its process."""
        program = os.path.join(SPACE, "lib", "collision_hulls", "collision_hulls_node")
        with self.script.started([program, "__ns:=left", "__name:=hulls", f"_output_root:={self.home}"], stdout=subprocess.DEVNULL) as node:
            self.rviz("type", "node", "/left/hulls")
            self.rviz.wait("advice", "text", "press Build")
            self.rviz("click", "build")
            self.rviz.wait("totals", "text", "^9 links", self.script.WAIT)
            self.settle()
            yield node

    def test_a_node_that_never_answers_does_not_hold_the_panel(self):
        with self.built_on_the_left() as node:
            os.kill(node.pid, signal.SIGSTOP)
            try:
                self.rviz("choose", "shoulder_link")
                self.rviz("key", "tolerance", "Right", 1)
                time.sleep(1)  # it has been asked
                self.rviz("type", "node", "collision_hulls")
                self.rviz.wait("totals", "text", "^9 links")
            finally:
                os.kill(node.pid, signal.SIGCONT)

    def test_a_node_in_another_name_space_is_found(self):
        with self.built_on_the_left():
            pass
        self.rviz.wait("advice", "text", "no node /left/hulls")
        self.rviz("type", "node", "collision_hulls")
        self.rviz.wait("totals", "text", "^9 links")


if __name__ == "__main__":
    rostest.rosrun("collision_hulls", "panel_test", PanelTest)
