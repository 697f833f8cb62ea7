#!/usr/bin/python3
"""Whatever starts first, a viewer that drops markers of unknown frames, as rviz does, ends up with those of every link."""
import os
import subprocess
import threading
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from robots import Folder, wait_until
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
        threading.Timer(self.deaf_for, self.frames.update, [[t.child_frame_id for t in message.transforms] + ["base"]]).start()

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
    @classmethod
    def setUpClass(cls):
        cls.folder = Folder()
        cls.addClassCleanup(cls.folder.remove)
        rospy.set_param("/robot_description", cls.folder.small_robot())
        os.environ["COLLISION_HULLS_CACHE"] = cls.folder.file("cache")

    def start_node(self, name):
        node = subprocess.Popen([roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0], f"__name:={name}", "_auto:=true",
                                 f"_output:={self.folder.output}"], stdout=subprocess.DEVNULL)
        self.addCleanup(self.end, node)
        return node

    @staticmethod
    def end(node):
        if node.poll() is None:
            node.terminate()
            node.wait(20)

    def publish_frames(self):
        """base -> arm -> tip, as robot_state_publisher does once."""
        publisher = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        message = TFMessage()
        for parent, child in (("base", "arm"), ("arm", "tip")):
            transform = TransformStamped()
            transform.header.frame_id, transform.child_frame_id = parent, child
            transform.transform.rotation.w = 1
            message.transforms.append(transform)
        publisher.publish(message)
        return publisher

    def assert_all_is_drawn(self, viewer):
        self.assertTrue(wait_until(lambda: viewer.links() == {"base", "arm"}, 15), viewer.links())
        viewer.close()

    def view(self, name, **options):
        viewer = Viewer(f"/{name}/hulls", **options)
        self.addCleanup(viewer.close)
        return viewer

    def test_frames_that_come_last(self):
        for start in range(STARTS):
            name = f"frames_last_{start}"
            viewer = self.view(name)
            node = self.start_node(name)
            self.assertTrue(wait_until(lambda: rospy.has_param(f"/{name}/robot_description")))  # the result is published
            rospy.sleep(0.8)  # longer than until the first repeat
            self.assertEqual(set(), viewer.links())
            frames = self.publish_frames()
            self.assert_all_is_drawn(viewer)
            frames.unregister()
            self.end(node)

    def test_viewer_that_comes_last(self):
        frames = self.publish_frames()
        for start in range(STARTS):
            name = f"viewer_last_{start}"
            node = self.start_node(name)
            self.assertTrue(wait_until(lambda: rospy.has_param(f"/{name}/robot_description")))
            self.assert_all_is_drawn(self.view(name))
            self.end(node)
        frames.unregister()

    def test_viewer_that_hears_of_frames_later_than_the_node(self):
        for start in range(STARTS):
            name = f"late_{start}"
            viewer = self.view(name, deaf_for=0.4 * start)
            node = self.start_node(name)
            frames = self.publish_frames()
            self.assert_all_is_drawn(viewer)
            frames.unregister()
            self.end(node)


if __name__ == "__main__":
    rospy.init_node("view_test")
    rostest.rosrun("collision_hulls", "view_test", ViewTest)
