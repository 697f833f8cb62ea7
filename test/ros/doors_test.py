#!/usr/bin/python3
"""What a request may read and write (src/ros/places.cpp), whoever runs the node, and a master that is restarted (src/ros/master_watch.cpp)."""
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import unittest

import robots
import rosgraph
import roslib.packages
import rospy
import rostest
from robots import NODE, decompose
from visualization_msgs.msg import Marker, MarkerArray

PROGRAM = roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0]
NOBODY = 65534


class DoorsTest(unittest.TestCase):
    def setUp(self):
        """A node that may write below `results` and read from `open`; `shut` is beside them."""
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        for name in ("open", "shut", "home"):
            os.mkdir(self.folder.file(name))
            robots.write_stl(self.folder.file(name + "/box.stl"), robots.box(0.1, 0.05, 0.03))
        self.log = self.folder.file("log")

    def start(self, *arguments, **options):
        """A node, with a home of its own."""
        for name in ("auto", "base", "output", "output_root", "read_roots"):
            if rospy.has_param(f"{NODE}/{name}"):
                rospy.delete_param(f"{NODE}/{name}")
        options.setdefault("env", dict(os.environ, ROS_HOME=self.folder.file("home"), ROS_LOG_DIR=self.folder.file("home")))
        with open(self.log, "w", encoding="utf-8") as log:
            node = subprocess.Popen([PROGRAM, "__name:=collision_hulls", "_cache:=false", *arguments], stdout=log, stderr=log, **options)
        self.addCleanup(self.end, node)
        return node

    def start_confined(self, *arguments):
        return self.start("_output_root:=" + self.folder.results, "_read_roots:=" + self.folder.file("open"), *arguments)

    @staticmethod
    def end(node):
        node.kill()
        node.wait()

    def said(self):
        return pathlib.Path(self.log).read_text(encoding="utf-8")

    def decompose(self, uri, output="", base="", name="small", node=NODE):
        robot = robots.chain(name, [("base", robots.link("base", uri))])
        return decompose(node, robot_description=robot, output=output, base=base, method="bounding_box", brief=True)

    def assert_done(self, response, place):
        self.assertTrue(response.success, response.message)
        self.assertEqual(place, os.path.dirname(os.path.dirname(response.urdf_path)))

    def assert_refused(self, response, *parts):
        self.assertFalse(response.success)
        self.assertEqual("", response.urdf_path)
        for part in parts:
            self.assertIn(part, response.message)

    # Writing.

    def test_writes_below_its_root(self):
        self.start_confined()
        uri = self.folder.uri("open/box.stl")
        for output, place in (("", "small_collision"), ("a/b", "a/b"), (self.folder.output, "made"), ("a/../c", "c")):
            self.assert_done(self.decompose(uri, output), os.path.join(self.folder.results, place))
        before = sorted(os.listdir(self.folder.path))
        os.symlink(self.folder.file("shut"), self.folder.file("results/out"))
        for output in (self.folder.file("shut/made"), "../made", ".", "out/made", "/"):
            self.assert_refused(self.decompose(uri, output), "lies outside", self.folder.results, "~output_root (output_root:=DIR of")
        self.assertEqual(["box.stl"], os.listdir(self.folder.file("shut")))
        self.assertEqual(before, sorted(os.listdir(self.folder.path)))

    def test_the_root_is_in_ros_home(self):
        self.start("_read_roots:=" + self.folder.file("open"))
        self.assert_done(self.decompose(self.folder.uri("open/box.stl")), self.folder.file("home/collision_hulls_output/small_collision"))

    def test_the_root_may_be_given_from_home(self):
        """By a shell that leaves ~ as it is."""
        self.start("_output_root:=~/models", "_read_roots:=" + self.folder.file("open"), env=dict(os.environ, HOME=self.folder.file("home")))
        self.assert_done(self.decompose(self.folder.uri("open/box.stl")), self.folder.file("home/models/small_collision"))

    def test_the_node_s_own_output_may_lie_elsewhere(self):
        self.start_confined("_output:=" + self.folder.file("shut/made"))
        uri = self.folder.uri("open/box.stl")
        self.assert_done(self.decompose(uri), self.folder.file("shut/made"))
        self.assert_refused(self.decompose(uri, self.folder.file("shut/other")))

    def test_nodes_in_namespaces_have_folders_of_their_own(self):
        """As two arms of the same kind have nodes that share their home."""
        uri = self.folder.uri("open/box.stl")
        for side in ("left", "right"):
            self.start_confined(f"__ns:=/{side}")
            place = os.path.join(self.folder.results, side, "small_collision")
            self.assert_done(self.decompose(uri, node=f"/{side}{NODE}"), place)
            if side == "left":
                shutil.rmtree(os.path.join(place, "meshes"))  # so that the right one's hulls can only be its own
        description = pathlib.Path(place, "urdf/small.urdf").read_text(encoding="utf-8")
        hull = re.search(r"package://small_collision/[^\"']*", description).group()
        self.assert_done(self.decompose(hull, "again", node=f"/right{NODE}"), os.path.join(self.folder.results, "again"))

    def test_another_robot_does_not_replace_the_node_s_own_model(self):
        self.start_confined("_output:=" + self.folder.file("shut/made"))
        uri = self.folder.uri("open/box.stl")
        for _ in range(2):
            self.assert_done(self.decompose(uri), self.folder.file("shut/made"))
        self.assert_refused(self.decompose(uri, name="other"), "holds the model of robot 'small'", "robot 'other' in the field `output`")
        self.assert_done(self.decompose(uri, "other", name="other"), os.path.join(self.folder.results, "other"))

    # Reading.

    def test_finds_the_packages_that_it_wrote(self):
        self.start_confined()
        first = self.decompose(self.folder.uri("open/box.stl"), "first")
        hull = re.search(r"package://first/[^\"']*", pathlib.Path(first.urdf_path).read_text(encoding="utf-8")).group()
        self.assert_done(self.decompose(hull, "second"), os.path.join(self.folder.results, "second"))

    def test_reads_from_its_roots(self):
        self.start_confined()
        os.symlink(self.folder.file("shut/box.stl"), self.folder.file("open/link.stl"))
        for uri in ("file:///proc/self/environ", self.folder.uri("shut/box.stl"), self.folder.file("open/../shut/box.stl"), self.folder.uri("open/link.stl")):
            self.assert_refused(self.decompose(uri), "lies outside", self.folder.file("open"), "~read_roots")

    def test_reads_the_description_s_folder(self):
        base = self.folder.file("shut/small.urdf")
        self.start("_base:=" + base)
        self.assert_refused(self.decompose("box.stl", base=base))
        pathlib.Path(base).write_text("<robot/>", encoding="utf-8")
        for uri in ("box.stl", self.folder.uri("shut/box.stl")):
            self.assertTrue(self.decompose(uri, base=base).success)
        self.assert_refused(self.decompose("../open/box.stl", base=base))

    def test_a_request_s_text_is_not_from_the_launch_file_s_folder(self):
        base = self.folder.file("shut/small.urdf")
        pathlib.Path(base).write_text("<robot/>", encoding="utf-8")
        self.start("_base:=" + base)
        self.assertIn("came without a file name", self.decompose("box.stl").message)
        self.assertIn("give an absolute path", self.decompose("box.stl", base="small.urdf").message)
        self.assert_refused(self.decompose("box.stl", base=self.folder.file("open/small.urdf")))

    def test_reads_packages(self):
        self.start_confined()
        finger = os.path.realpath(os.path.join(roslib.packages.get_pkg_dir("collision_hulls"), "meshes/finger.stl"))
        scaled = robots.link("base", "package://collision_hulls/meshes/finger.stl").replace("<mesh ", '<mesh scale="0.001 0.001 0.001" ')
        for text in (scaled, scaled.replace("package://collision_hulls/meshes/finger.stl", finger)):
            response = decompose(robot_description=robots.chain("small", [("base", text)]), method="bounding_box")
            self.assertTrue(response.success, response.message)
        for uri in ("package://collision_hulls/../x.stl", "package://-h/x.stl", "package://collision_hulls/meshes/finger.stl%00"):
            self.assert_refused(self.decompose(uri), "'" + uri)

    def test_parameters_that_are_set_later_open_nothing(self):
        self.start_confined()
        self.assert_refused(self.decompose(self.folder.uri("shut/box.stl")))
        for name in ("read_roots", "output_root", "package_path"):
            rospy.set_param(f"{NODE}/{name}", self.folder.path)
            self.addCleanup(rospy.delete_param, f"{NODE}/{name}")
        self.assert_refused(self.decompose(self.folder.uri("shut/box.stl")), "lies outside")
        self.assert_refused(self.decompose(self.folder.uri("open/box.stl"), self.folder.file("shut/made")), "lies outside")

    def test_roots_of_the_wrong_type(self):
        rospy.set_param(NODE + "/read_roots", 3)
        node = subprocess.Popen([PROGRAM, "__name:=collision_hulls"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end, node)
        self.assertIn("read_roots is '3', not a text or a list of texts: set it to one", node.communicate(timeout=30)[0])
        self.assertEqual(1, node.returncode)
        rospy.delete_param(NODE + "/read_roots")

    # Parameters without effect, and paths.

    def test_mistyped_parameters_are_named(self):
        self.addCleanup(lambda: [rospy.delete_param(f"{NODE}/{name}") for name in ("tolerence", "opacity")])
        rospy.set_param(NODE + "/tolerance", "5mm")
        self.addCleanup(rospy.delete_param, NODE + "/tolerance")
        for opacity, part in (("lots", "/opacity is 'lots', not a number: set it to one"), ("7", "/opacity is 7: set it to a number from 0 to 1")):
            node = self.start_confined("_tolerence:=5mm", "_opacity:=" + opacity)
            self.assertTrue(robots.answers())
            self.assertIn(NODE + "/tolerence has no effect; did you mean 'tolerance'?", self.said())
            self.assertEqual(1, self.said().count("has no effect"), self.said())
            self.assertIn(part, self.said())
            self.end(node)

    def test_the_log_spells_paths_as_they_are(self):
        os.rename(self.folder.results, self.folder.file("Ergebnis für Jörg"))
        node = self.start("_output_root:=" + self.folder.file("Ergebnis für Jörg"), "_read_roots:=" + self.folder.path)
        self.assertTrue(self.decompose(self.folder.uri("open/box.stl")).success)
        self.end(node)
        self.assertIn("Written to " + self.folder.file("Ergebnis für Jörg/small_collision"), self.said())

    # Users.

    @unittest.skipIf(os.geteuid() != 0, "only root can become another user")
    def test_an_ordinary_user(self):
        roots = self.start_confined()
        self.assertTrue(robots.answers())
        self.assertIn("running as root", self.said())
        self.end(roots)
        for folder, _, _ in os.walk(self.folder.path):
            os.chown(folder, NOBODY, NOBODY)
        os.chmod(self.folder.path, 0o755)

        def become_nobody():
            os.setgid(NOBODY)
            os.setuid(NOBODY)

        if subprocess.run(["test", "-x", PROGRAM], preexec_fn=become_nobody, check=False).returncode != 0:
            self.skipTest("other users cannot reach " + PROGRAM)
        home = self.folder.file("home")
        node = self.start("_read_roots:=" + self.folder.file("open"), "_cache:=true", preexec_fn=become_nobody,
                          env={**os.environ, "HOME": home, "ROS_HOME": home, "ROS_LOG_DIR": home})
        self.assert_done(self.decompose(self.folder.uri("open/box.stl")), self.folder.file("home/collision_hulls_output/small_collision"))
        self.assertTrue(os.path.isdir(os.path.join(home, "collision_hulls")), "the cache")
        self.assertIsNone(node.poll())
        self.assertNotIn("running as root", self.said())

    # Restarts.

    def test_a_new_node_clears_what_rviz_shows(self):
        self.start_confined()
        message = rospy.wait_for_message(NODE + "/markers", MarkerArray, timeout=30)
        self.assertEqual([Marker.DELETEALL], [marker.action for marker in message.markers])

    def start_master(self, port):
        with open(self.folder.file("master_log"), "w", encoding="utf-8") as log:
            master = subprocess.Popen(["rosmaster", "--core", "-p", str(port)], stdout=log, stderr=log, start_new_session=True)
        self.addCleanup(self.end, master)
        self.assertTrue(robots.wait_until(lambda: rosgraph.is_master_online(f"http://localhost:{port}")))
        return master

    @unittest.skipIf(shutil.which("rosmaster") is None, "no program rosmaster")
    def test_a_master_that_was_restarted(self):
        with socket.socket() as free:
            free.bind(("localhost", 0))
            port = free.getsockname()[1]
        uri = f"http://localhost:{port}"
        parameters = rosgraph.Master("/doors_test", uri)
        first = self.start_master(port)
        parameters.setParam("/robot_description", "rubbish")
        parameters.setParam(NODE + "/robot_description", "an earlier node's result")
        node = self.start("_tolerance:=3mm", env=dict(os.environ, ROS_MASTER_URI=uri, ROS_HOME=self.folder.file("home")))
        self.assertTrue(robots.wait_until(lambda: any(NODE + "/decompose" in name for name, _ in parameters.getSystemState()[2])))
        self.end(first)
        self.assertIsNone(node.poll(), "without a master it waits")
        self.start_master(port)
        self.assertEqual(1, node.wait(30))
        self.assertIn("start it again", self.said())
        self.assertFalse(parameters.hasParam(NODE + "/robot_description"))
        self.assertEqual(("3mm", "rubbish"), (parameters.getParam(NODE + "/tolerance"), parameters.getParam("/robot_description")))

    def test_two_interrupts(self):
        node = self.start_confined()
        self.assertTrue(robots.answers())
        node.send_signal(signal.SIGINT)
        node.send_signal(signal.SIGINT)
        self.assertIn(node.wait(10), (0, -signal.SIGINT))


if __name__ == "__main__":
    rospy.init_node("doors_test")
    rostest.rosrun("collision_hulls", "doors_test", DoorsTest)
