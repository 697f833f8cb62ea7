#!/usr/bin/python3
"""decompose_client as a user calls it: table, progress, Ctrl-C, and usage errors."""
import os
import pty
import shutil
import signal
import subprocess
import unittest
from unittest import mock

import robots
import roslib.packages
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from robots import NODE, decompose

CLIENT = roslib.packages.find_node("collision_hulls", "decompose_client")[0]


class ClientTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        rospy.wait_for_service(NODE + "/decompose", timeout=30)

    def urdf(self, text):
        with open(self.folder.file("robot.urdf"), "w", encoding="utf-8") as file:
            file.write(text)
        return self.folder.file("robot.urdf")

    def run_client(self, *arguments):
        """Its exit status, standard output and standard error."""
        done = subprocess.run([CLIENT, *arguments], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def start_slow(self, **options):
        """A client whose goal is being worked on."""
        client = subprocess.Popen([CLIENT, self.urdf(self.folder.slow_robot()), "-o", self.folder.output], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.addCleanup(self.interrupt, client)
        self.assertEqual("reading 15 meshes\n", client.stderr.readline())
        return client

    @staticmethod
    def interrupt(client):
        """The node is free afterwards."""
        if client.poll() is None:
            client.send_signal(signal.SIGINT)
            client.communicate()

    def test_table_and_place(self):
        urdf = self.urdf(self.folder.small_robot())
        status, out, err = self.run_client(urdf, "-o", self.folder.output, "-t", "1cm,5%")
        self.assertEqual(0, status, err)
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output, tolerance=0.01, relative_tolerance=0.05)
        self.assertEqual(response.table.splitlines()[0], out.splitlines()[0])  # others hold times
        self.assertIn("Written to " + self.folder.output, out)
        self.assertTrue(os.path.isfile(os.path.join(self.folder.output, "report.json")))
        self.assertEqual("reading 2 meshes", err.splitlines()[0])
        self.assertNotIn("\r", out + err)

    def test_bar_on_a_terminal(self):
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        subprocess.run([CLIENT, self.urdf(self.folder.small_robot()), "-o", self.folder.output], stdout=subprocess.DEVNULL, stderr=slave,
                       check=True)
        os.close(slave)
        seen = os.read(master, 100000).decode()
        self.assertIn("[....................]   0 %  reading 2 meshes", seen)
        self.assertTrue(seen.endswith("\r\033[K"), repr(seen[-100:]))

    def test_fits_to_a_scene(self):
        with open(self.folder.file("empty.yaml"), "w", encoding="utf-8") as file:
            file.write("name: nothing\nbodies: []\n")
        urdf = self.urdf(self.folder.small_robot())
        status, out, err = self.run_client(urdf, "-o", self.folder.output, "--scene", self.folder.file("empty.yaml"), "--clearance", "2cm")
        self.assertEqual(0, status, err)
        self.assertIn("'nothing'", out)

    def test_options_of_a_fit(self):
        with open(self.folder.file("empty.yaml"), "w", encoding="utf-8") as file:
            file.write("name: nothing\nbodies: []\n")
        with open(self.folder.file("robot.srdf"), "w", encoding="utf-8") as file:
            file.write('<robot name="another"><disable_collisions link1="no" link2="such" reason="Never"/></robot>')
        fit = [self.urdf(self.folder.small_robot()), "-o", self.folder.output, "--scene", self.folder.file("empty.yaml"), "--clearance", "2cm"]
        status, out, err = self.run_client(*fit, "--samples", "123", "--hulls-only")
        self.assertEqual(0, status, err)
        self.assertIn("123 random configurations", out)
        self.assertNotIn("primitive", out)
        for more, word in ((["--srdf", self.folder.file("robot.srdf")], "give the SRDF of this robot"),
                           (["--srdf", "nosuch.srdf"], "SRDF 'nosuch.srdf' is no file"),
                           (["--srdf", "package://a/b.srdf"], "SRDF 'package://a/b.srdf' is no file"),
                           (["--configurations", "nosuch.csv"], "configurations 'nosuch.csv' is no file"),
                           (["--joints", "wrist"], "joints 'wrist' matches no joint"),
                           (["--at", "elbow=1", "--at", "knee"], "at 'knee' is invalid"),
                           (["--max-step", "0.1"], "none are given")):
            status, out, err = self.run_client(*fit, *more)
            self.assertEqual((2, ""), (status, out), more)
            self.assertIn(word, err)
        self.assertIn("--samples is for a fit", self.run_client(fit[0], "--samples", "9")[2])

    def test_interrupts_cancel(self):
        for interrupt in (signal.SIGINT, signal.SIGTERM):
            client = self.start_slow()
            states = []
            watch = rospy.Subscriber(NODE + "/decompose_action/status", GoalStatusArray, lambda array: states.append(array.status_list))
            client.send_signal(interrupt)
            _, err = client.communicate(timeout=60)
            self.assertEqual(130, client.returncode)
            self.assertIn("interrupted; nothing was written", err)
            # The goal's end is the client's: the node works for nobody now.
            self.assertNotIn("busy: ", decompose(robot_description="rubbish").message)
            self.assertTrue(robots.wait_until(lambda: states and states[-1][-1].status == GoalStatus.PREEMPTED), "not preempted")
            watch.unregister()
            self.assertEqual([], os.listdir(self.folder.results))

    def test_busy_node(self):
        self.start_slow()
        status, out, err = self.run_client(self.urdf(self.folder.small_robot()), "-o", self.folder.output)
        self.assertEqual((2, ""), (status, out))
        self.assertIn("busy: ", err)

    def test_failed_mesh(self):
        urdf = self.urdf(self.folder.small_robot())
        os.remove(self.folder.file("box.stl"))
        status, out, _ = self.run_client(urdf, "-o", self.folder.output)
        self.assertEqual(1, status)
        self.assertIn("box.stl", out)

    def test_xacro_is_expanded(self):
        """By a program in xacro's place; without one the file is refused, as the node would take its elements for a robot's."""
        os.rename(self.urdf(self.folder.small_robot().replace("<visual>", "<VISUAL>")), self.folder.file("robot.xacro"))
        with mock.patch.dict(os.environ, PATH="/usr/bin:/bin"):
            if shutil.which("xacro") is None:
                status, out, err = self.run_client(self.folder.file("robot.xacro"), "-o", self.folder.output)
                self.assertEqual((2, ""), (status, out))
                self.assertIn("robot.xacro' is a xacro file, but 'xacro' is not on PATH", err)
        with open(self.folder.file("xacro"), "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\n[ "$2" = "side:=a b" ] || exit 3\nsed "s/<VISUAL>/<visual>/g" "$1"\n')
        os.chmod(self.folder.file("xacro"), 0o755)
        with mock.patch.dict(os.environ, PATH=self.folder.path + ":" + os.environ["PATH"]):
            status, out, err = self.run_client(self.folder.file("robot.xacro"), "side:=a b", "-o", self.folder.output)
        self.assertEqual(0, status, err)
        self.assertIn("bracket.obj", out)

    def test_links_leave_the_file_its_place(self):
        urdf = self.urdf(self.folder.small_robot())
        for words in (["--links", "base", "arm", urdf], [urdf, "--links", "base,arm"], ["--links", "base", "x:=1", urdf, "-t", "5%"],
                      ["--links", "base,", "arm", "-t", "5%", urdf], ["--links=base", urdf]):
            with self.subTest(words):
                status, out, err = self.run_client("-o", self.folder.output, *words)
                self.assertEqual(0, status, err)
                self.assertIn("bracket.obj", out)
                self.assertEqual("arm" in " ".join(words), "box.stl" in out, out)

    def test_help_has_the_arguments_of_a_description(self):
        self.assertIn("decompose_client [URDF [NAME:=VALUE...]]", self.run_client("--help")[1])

    def test_wrong_use(self):
        urdf = self.urdf(self.folder.small_robot())
        for arguments, word in (([urdf, "-t", "5x"], "'5x'"), ([urdf, "-t", "1%,2%"], "'1%,2%'"), ([urdf, "-t", "1,5%"], "'1,5%'"), ([urdf, "-t", "0"], "'0'"),
                                ([urdf, "-t", "-1mm"], "-t"), ([urdf, "-t", ""], "''"), ([urdf, "--scene", "x.yaml"], "--clearance"),
                                ([urdf, "--scene", "x.yaml", "--clearance", "5%"], "'5%'"), ([urdf, "-m", "magic"], "'magic'"),
                                (["nowhere.urdf"], "'nowhere.urdf' does not exist (looked for '"), (["nowhere.xacro"], "'nowhere.xacro' does not exist"),
                                ([self.folder.path], "is a folder; give"), ([urdf, "--scene", "x.yaml", "--clearance", "1cm"], "scene 'x.yaml' is no file (looked for '"),
                                ([urdf, "--scene", self.folder.path, "--clearance", "1cm"], "is no file"), ([urdf, "--links", "leg"], "'leg'"), ([urdf, "--links", ","], "--links has no name"),
                                ([self.folder.file("box.stl")], "decompose takes meshes: rosrun collision_hulls decompose " + self.folder.file("box.stl")),
                                ([urdf, "--tolerence", "5mm"], "there is no option --tolerence; did you mean --tolerance?\n"),
                                ([urdf, "--max-hulls=3"], "--max-hulls; start the node with it, as in 'roslaunch collision_hulls decompose.launch max_hulls:=VALUE'"),
                                ([urdf, "--no-cache"], "decompose.launch cache:=false'"), ([urdf, "--spheres"], "decompose.launch shapes:=VALUE'"),
                                (["--scale", "2", urdf], "there is no option --scale; only the programs decompose and fit_scene have it"),
                                ([urdf, "--xyzzy"], "see decompose_client --help"), ([urdf, "other.urdf"], "'other.urdf' is not understood: give one file")):
            status, out, err = self.run_client(*arguments)
            self.assertEqual((2, ""), (status, out), arguments)
            self.assertIn(word, err)
            self.assertNotIn("Traceback", err)
            self.assertNotIn("usage", err)
        with mock.patch.dict(os.environ, ROS_MASTER_URI="nonsense"):
            self.assertIn("ROS_MASTER_URI is 'nonsense', and no address: set it to one", self.run_client(urdf)[2])


if __name__ == "__main__":
    rospy.init_node("client_test")
    rostest.rosrun("collision_hulls", "client", ClientTest)
