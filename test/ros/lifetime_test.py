#!/usr/bin/python3
"""The node's start and end: a run by itself at start-up, and an interrupt in the middle of one."""
import os
import signal
import subprocess
import threading
import unittest

import robots
import roslib.packages
import rospy
import rostest
from robots import NODE
from visualization_msgs.msg import MarkerArray


class LifetimeTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)

    def start_node(self, robot, **options):
        rospy.set_param("/robot_description", robot)
        program = roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0]
        options["env"] = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        node = subprocess.Popen([program, "_auto:=true", "_cache:=false", "_method:=hacd", "_output:=" + self.folder.output, *robots.ROOTS], **options)
        self.addCleanup(self.end, node)
        rospy.wait_for_service(NODE + "/decompose", timeout=30)
        return node

    @staticmethod
    def end(node):
        if node.poll() is None:
            node.kill()
        node.wait()

    @staticmethod
    def namespaces():
        return [marker.ns for marker in rospy.wait_for_message(NODE + "/markers", MarkerArray, timeout=60).markers]

    @staticmethod
    def text_of(log):
        with open(log.name, encoding="utf-8") as file:
            return file.read()

    @staticmethod
    def call_until_taken(**request):
        """Calls again while the node works for someone else; the node's end is this call's end."""
        try:
            while robots.decompose(**request).message.startswith("busy: "):
                pass
        except (rospy.ServiceException, rospy.ROSException):
            pass

    def test_an_argument(self):
        program = roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0]
        helped = subprocess.run([program, "--help"], capture_output=True, text=True, timeout=10, check=True)
        self.assertIn("roslaunch collision_hulls decompose.launch", helped.stdout)
        refused = subprocess.run([program, "arm.urdf"], capture_output=True, text=True, timeout=10, check=False)
        self.assertEqual(2, refused.returncode)
        self.assertIn("takes no argument 'arm.urdf'", refused.stderr)

    def test_run_at_start(self):
        node = self.start_node(self.folder.small_robot())
        self.assertTrue(robots.wait_until(lambda: "hulls/base" in self.namespaces()))
        self.assertTrue(os.path.isfile(os.path.join(self.folder.output, "report.json")))
        node.send_signal(signal.SIGINT)
        self.assertEqual(0, node.wait(10))

    def test_rubbish_at_start(self):
        node = self.start_node("rubbish")
        self.assertTrue(robots.answers())
        self.assertIsNone(node.poll())

    def test_interrupt_in_the_middle(self):
        for interrupt in (signal.SIGINT, signal.SIGTERM):
            node = self.start_node(self.folder.slow_robot())
            refused = robots.decompose(robot_description=self.folder.small_robot())
            self.assertIn("busy: ", refused.message)
            node.send_signal(interrupt)
            self.assertEqual(0, node.wait(10))
            self.assertEqual([], os.listdir(self.folder.results))

    def test_cancelled_run_is_no_error(self):
        with open(self.folder.file("log"), "w+", encoding="utf-8") as log:
            node = self.start_node(self.folder.slow_robot(), stdout=log, stderr=log)
            self.assertTrue(robots.wait_until(lambda: "reading 15 meshes" in self.text_of(log)))
            node.send_signal(signal.SIGINT)
            node.wait(10)
            lines = self.text_of(log)
        self.assertIn("cancelled; nothing was written", lines)
        self.assertNotIn("ERROR", lines)

    def test_one_error_for_one_fault(self):
        with open(self.folder.file("log"), "w+", encoding="utf-8") as log:
            node = self.start_node("rubbish", stdout=log, stderr=log)
            self.assertTrue(robots.wait_until(lambda: "XML" in self.text_of(log)))
            node.send_signal(signal.SIGINT)
            node.wait(10)
            lines = self.text_of(log)
        self.assertEqual(1, lines.count("XML"), lines)
        self.assertEqual(1, lines.count("ERROR"), lines)

    def test_interrupt_during_a_service_call(self):
        node = self.start_node("rubbish")
        request = {"robot_description": self.folder.slow_robot(), "output": self.folder.output}
        caller = threading.Thread(target=self.call_until_taken, kwargs=request, daemon=True)
        caller.start()
        self.assertTrue(robots.wait_until(lambda: "busy: " in robots.decompose(robot_description="rubbish").message))
        node.send_signal(signal.SIGINT)
        self.assertEqual(0, node.wait(10))
        caller.join(10)
        self.assertEqual([], os.listdir(self.folder.results))


if __name__ == "__main__":
    rospy.init_node("lifetime_test")
    rostest.rosrun("collision_hulls", "lifetime_test", LifetimeTest)
