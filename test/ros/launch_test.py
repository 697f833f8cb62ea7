#!/usr/bin/python3
"""The launch files' argument `config`: a file beside the robot's, named relative to the folder in which roslaunch runs. What they say of
files without a text. How view.launch starts rviz. Tests launch/decompose.launch, launch/view.launch, launch/file_text and
scripts/rviz_at_root."""
import contextlib
import importlib.machinery
import importlib.util
import json
import os
import signal
import subprocess
import unittest
from unittest import mock

import robots
import rospkg
import rospy
import rostest
import yaml

SPACE = os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0]  # devel
CONFIG = "default: {tolerance: 4mm}\nlinks:\n  base: {method: bounding_box}  # 'quotes' and $(signs) stay as they are\n  arm: keep\n"


class LaunchTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        self.write("robot.urdf", self.folder.small_robot())
        self.write("hulls.yaml", CONFIG)
        # As in a shell that has sourced setup.bash: tests have the source folder on the path instead.
        self.environment = dict(os.environ, ROS_PACKAGE_PATH=SPACE + "/share", PWD=self.folder.path)

    def write(self, name, text):
        with open(self.folder.file(name), "w", encoding="utf-8") as file:
            file.write(text)

    def replace_rviz(self, script):
        """By lines for a shell, which runs them in the test's folder."""
        os.makedirs(self.folder.file("bin"), exist_ok=True)
        self.write("bin/rviz", f'#!/bin/sh\ncd "$ROS_HOME" && {script}\n')
        os.chmod(self.folder.file("bin/rviz"), 0o755)
        self.environment.update(PATH=self.folder.file("bin") + ":" + os.environ["PATH"], ROS_HOME=self.folder.path)

    @contextlib.contextmanager
    def launched(self, file, *arguments, robot=("robot:=robot.urdf",)):
        """roslaunch takes no notice of `robot:=` without a value: pass robot=() to leave it out."""
        command = ["roslaunch", "collision_hulls", file, *robot, "output:=results/made", f"output_root:={self.folder.path}", *arguments]
        with open(self.folder.file("log"), "w+", encoding="utf-8") as log:
            nodes = subprocess.Popen(command, cwd=self.folder.path, env=self.environment, stdout=log, stderr=log)
            try:
                yield nodes
            finally:
                if nodes.poll() is None:
                    nodes.send_signal(signal.SIGINT)
                nodes.wait(30)

    def log(self):
        with open(self.folder.file("log"), encoding="utf-8") as log:
            return log.read()

    def assert_configured(self, file, *arguments):
        report = os.path.join(self.folder.output, "report.json")
        with self.launched(file, "config:=hulls.yaml", *arguments):
            self.assertTrue(robots.wait_until(lambda: os.path.exists(report), 60), self.log())
            self.assertEqual(CONFIG, rospy.get_param(robots.NODE + "/config"))
            self.assertNotIn("has no effect", self.log())  # nothing that the launch file sets looks mistyped
            # What a file is told of the run while the node goes on.
            self.assertTrue(robots.wait_until(lambda: "Written to " + self.folder.output in self.log(), 10), self.log())
        for part in ("robot 'small': 1 hull for 1 mesh, 1 degraded; largest protrusion ", '<param name="robot_description" textfile='):
            self.assertIn(part, self.log())
        with open(report, encoding="utf-8") as written:
            rows = {row["link"]: row for row in json.load(written)["links"]}
        self.assertEqual(("bounding_box", 1), (rows["base"]["method"], rows["base"]["hulls"]))
        self.assertEqual("kept", rows["arm"]["status"])
        with open(os.path.join(self.folder.output, "config", "small_hulls.yaml"), encoding="utf-8") as written:
            self.assertIn("tolerance: 4mm", written.read())

    def test_decompose_launch(self):
        self.assert_configured("decompose.launch")

    def test_view_launch(self):
        self.assert_configured("view.launch", "gui:=false", "state:=false")

    def test_the_files_default_counts_before_the_arguments(self):
        self.assert_configured("decompose.launch", "tolerance:=9mm", "method:=hacd")

    def test_files_without_a_text_are_named(self):
        os.mkdir(self.folder.file("folder"))
        for argument, words in (("config:=nowhere.yaml", "nowhere.yaml' does not exist; check the path"), ("robot:=nowhere.urdf", "nowhere.urdf' does not exist"),
                                ("robot:=nowhere.xacro", "nowhere.xacro' does not exist"), ("robot:=folder", "folder' is a folder; give"),
                                ("robot:=box.stl", "box.stl' is no text"),
                                ("xacro_args:=a=b", "robot.urdf' is not a .xacro file, and takes no argument 'a=b'; leave out xacro_args"),
                                ("xacro_args:=a", "robot.urdf' cannot be given 'a': xacro_args takes NAME=VALUE"), ("xacro_args:=a=", "cannot be given 'a='")):
            with self.launched("decompose.launch", argument) as nodes:
                self.assertNotEqual(0, nodes.wait(30))
            self.assertIn(words, self.log())
            self.assertNotIn("Traceback (most", self.log())
            self.assertFalse(os.path.exists(self.folder.output))

    def test_without_a_robot_the_log_says_how_to_give_one(self):
        if rospy.has_param("/robot_description"):
            rospy.delete_param("/robot_description")
        words = "no robot description: start with robot:=FILE, or set the parameter /robot_description"
        with self.launched("decompose.launch", robot=()):
            self.assertTrue(robots.wait_until(lambda: words in self.log(), 30), self.log())

    def test_arguments_for_xacro(self):
        os.makedirs(self.folder.file("bin"))
        self.write("bin/xacro", '#!/bin/sh\nfile=$1\nshift\nfor word; do echo "<!-- [$word] -->"; done\ncat "$file"\n')
        os.chmod(self.folder.file("bin/xacro"), 0o755)
        self.environment.update(PATH=self.folder.file("bin") + ":" + os.environ["PATH"])
        os.rename(self.folder.file("robot.urdf"), self.folder.file("robot.xacro"))
        with self.launched("view.launch", "gui:=false", "state:=false", "robot:=robot.xacro", "xacro_args:=side=left 'name=a b=c'"):
            self.assertTrue(robots.wait_until(lambda: "<!-- [side:=left] -->\n<!-- [name:=a b=c] -->" in rospy.get_param("/robot_description", ""), 30), self.log())

    def test_what_the_package_path_found_is_named_for_later(self):
        package = self.folder.file("parts/foreign")
        os.makedirs(package)
        self.write("parts/foreign/package.xml", "<package format='2'><name>foreign</name></package>")
        os.rename(self.folder.file("box.stl"), os.path.join(package, "box.stl"))
        self.write("robot.urdf", robots.chain("small", [("base", robots.link("base", "package://foreign/box.stl"))]))
        with self.launched("decompose.launch", f"package_path:={self.folder.file('parts')}"):
            self.assertTrue(robots.wait_until(lambda: "Written to " + self.folder.output in self.log(), 60), self.log())
        self.assertIn(f":{self.folder.file('parts')}:$ROS_PACKAGE_PATH", self.log())

    def test_names_with_quotes(self):
        name = "Bob's \"6\\7\" "
        for file in ("robot.urdf", "hulls.yaml"):
            os.rename(self.folder.file(file), self.folder.file(name + file))
        with self.launched("decompose.launch", f"robot:={name}robot.urdf", f"config:={name}hulls.yaml"):
            self.assertTrue(robots.wait_until(lambda: os.path.exists(self.folder.output), 60), self.log())
            self.assertEqual(CONFIG, rospy.get_param(robots.NODE + "/config"))

    def test_rviz_sees_the_whole_robot_and_draws_less_without_a_gpu(self):
        """A program in rviz's place writes down its arguments. In a namespace."""
        self.replace_rviz('printf "%s\\n" "$@" > part && mv part arguments')
        self.environment.update(ROS_NAMESPACE="left", LIBGL_ALWAYS_SOFTWARE="1")
        with self.launched("view.launch", "state:=false", "distance:=3"):
            self.assertTrue(robots.wait_until(lambda: os.path.exists(self.folder.file("arguments")), 60), self.log())
            bounds = rospy.get_param("/left" + robots.NODE + "/view")
        with open(self.folder.file("arguments"), encoding="utf-8") as file:
            arguments = file.read().split("\n")
        self.assertEqual(["-f", "base", "-d"], arguments[:3])
        self.assertIn("--disable-anti-aliasing", arguments)
        with open(arguments[3], encoding="utf-8") as file:
            manager = yaml.safe_load(file)["Visualization Manager"]
        self.assertEqual(10, manager["Global Options"]["Frame Rate"])
        self.assertAlmostEqual(3 * bounds["radius"], manager["Views"]["Current"]["Distance"], places=5)

    def test_rviz_that_crashes_as_it_starts_is_started_once_more(self):
        self.replace_rviz("echo >> starts; kill -SEGV $$")
        with self.launched("view.launch", "state:=false", "required:=true") as nodes:
            nodes.wait(60)
        with open(self.folder.file("starts"), encoding="utf-8") as file:
            self.assertEqual("\n\n", file.read())
        self.assertIn("exit code 139", self.log())

    def test_rviz_ends_with_the_launch_and_on_its_own_failure(self):
        self.replace_rviz("trap 'touch ended; kill -SEGV $$' INT; echo >> started; while :; do sleep 0.1; done")
        with self.launched("view.launch", "state:=false"):
            self.assertTrue(robots.wait_until(lambda: os.path.exists(self.folder.file("started")), 60), self.log())
        self.assertTrue(os.path.exists(self.folder.file("ended")), self.log())
        with open(self.folder.file("started"), encoding="utf-8") as file:
            self.assertEqual("\n", file.read())  # a crash as it ends is no reason to start it
        self.replace_rviz("echo >> failures; exit 3")
        with self.launched("view.launch", "state:=false", "required:=true") as nodes:
            nodes.wait(60)
        with open(self.folder.file("failures"), encoding="utf-8") as file:
            self.assertEqual("\n", file.read())
        self.assertIn("exit code 3", self.log())

    def test_what_counts_as_a_machine_without_a_gpu(self):
        path = os.path.join(rospkg.RosPack().get_path("collision_hulls"), "scripts", "rviz_at_root")
        loader = importlib.machinery.SourceFileLoader("rviz_at_root", path)
        script = importlib.util.module_from_spec(importlib.util.spec_from_loader("rviz_at_root", loader))
        loader.exec_module(script)
        with mock.patch.dict(os.environ):
            os.environ.pop("LIBGL_ALWAYS_SOFTWARE", None)
            for gpus, expected in (((self.folder.path,), False), (("/nowhere",), True)):
                with mock.patch.object(script, "GPUS", gpus):
                    self.assertEqual(expected, script.draws_in_software())
            os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
            with mock.patch.object(script, "GPUS", (self.folder.path,)):
                self.assertTrue(script.draws_in_software())


if __name__ == "__main__":
    rospy.init_node("launch_test")
    rostest.rosrun("collision_hulls", "launch_test", LaunchTest)
