#!/usr/bin/python3
"""Whatever starts first, a viewer that drops markers of unknown frames, as rviz does, ends up with those of every link."""
import os
import re
import subprocess
import threading
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from robots import ROOTS, Folder, wait_until
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

STARTS = 5  # of the node, for each order


class Viewer:
    """What an rviz display keeps. `deaf_for`: seconds by which it hears of frames later than others."""

    def __init__(self, topic, deaf_for=0.0):
        self.deaf_for = deaf_for
        self.frames, self.kept, self.lock = set(), {}, threading.Lock()
        self.subscribers = [rospy.Subscriber("/tf_static", TFMessage, self.hear_of_frames), rospy.Subscriber(topic, MarkerArray, self.draw)]

    def hear_of_frames(self, message):
        frames = [frame for t in message.transforms for frame in (t.header.frame_id, t.child_frame_id)]
        threading.Timer(self.deaf_for, self.frames.update, [frames]).start()

    def draw(self, message):
        with self.lock:
            for marker in message.markers:
                if marker.action == Marker.DELETEALL:
                    self.kept.clear()
                elif marker.header.frame_id in self.frames:
                    self.kept[marker.ns, marker.id] = marker

    def links(self):
        with self.lock:
            return {name.split("/")[1] for name, _ in self.kept}

    def close(self):
        for subscriber in self.subscribers:
            subscriber.unregister()


class ViewTest(unittest.TestCase):
    """Every start has a node and link names of its own, so that no frame is known from an earlier one."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Folder()
        cls.addClassCleanup(cls.folder.remove)
        cls.transforms = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        os.environ["COLLISION_HULLS_CACHE"] = cls.folder.file("cache")

    def start_node(self, name):
        rospy.set_param("/robot_description", re.sub(r'"(base|arm|tip)"', rf'"{name}_\1"', self.folder.small_robot()))
        program = roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0]
        node = subprocess.Popen([program, f"__name:={name}", "_auto:=true", f"_output:={self.folder.output}", *ROOTS], stdout=subprocess.DEVNULL)
        self.addCleanup(self.end, node)
        return node

    @staticmethod
    def end(node):
        if node.poll() is None:
            node.terminate()
            node.wait(20)

    def publish_frames(self, name):
        """base -> arm -> tip, as robot_state_publisher does once."""
        message = TFMessage()
        for parent, child in (("base", "arm"), ("arm", "tip")):
            transform = TransformStamped()
            transform.header.frame_id, transform.child_frame_id = f"{name}_{parent}", f"{name}_{child}"
            transform.transform.rotation.w = 1
            message.transforms.append(transform)
        self.transforms.publish(message)

    def view(self, name, **options):
        viewer = Viewer(f"/{name}/hulls", **options)
        self.addCleanup(viewer.close)
        return viewer

    def wait_for_result(self, name):
        self.assertTrue(wait_until(lambda: rospy.has_param(f"/{name}/robot_description")))

    def assert_all_is_drawn(self, name, viewer, node):
        self.assertTrue(wait_until(lambda: viewer.links() == {f"{name}_base", f"{name}_arm"}, 15), viewer.links())
        viewer.close()
        self.end(node)

    def test_frames_that_come_last(self):
        for start in range(STARTS):
            name = f"frames_last_{start}"
            viewer, node = self.view(name), self.start_node(name)
            self.wait_for_result(name)
            rospy.sleep(0.8)  # longer than until the first repeat
            self.assertEqual(set(), viewer.links())
            self.publish_frames(name)
            self.assert_all_is_drawn(name, viewer, node)

    def test_viewer_that_comes_last(self):
        for start in range(STARTS):
            name = f"viewer_last_{start}"
            self.publish_frames(name)
            node = self.start_node(name)
            self.wait_for_result(name)
            self.assert_all_is_drawn(name, self.view(name), node)

    def test_viewer_that_hears_of_frames_later_than_the_node(self):
        for start in range(STARTS):
            name = f"late_{start}"
            viewer, node = self.view(name, deaf_for=0.4 * start), self.start_node(name)
            self.publish_frames(name)
            self.assert_all_is_drawn(name, viewer, node)


if __name__ == "__main__":
    rospy.init_node("view_test")
    rostest.rosrun("collision_hulls", "view_test", ViewTest)
