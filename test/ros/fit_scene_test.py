#!/usr/bin/python3
"""The service that fits a robot to a scene: what it makes, what it shows, and rubbish."""
import json
import os
import unittest

import robots
import rospy
import rostest
from collision_hulls.srv import FitScene
from robots import NODE
from visualization_msgs.msg import MarkerArray

# A block in the notch of the small robot's bracket: within its hull, and 2 cm from it.
BLOCK = "name: notch\nbodies:\n- {name: block, box: [0.02, 0.02, 0.02], pose: {xyz: [0.05, 0.05, 0.025]}}\n"


class FitSceneTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        self.robot = self.folder.small_robot()
        with open(self.folder.file("notch.yaml"), "w") as file:
            file.write(BLOCK)
        rospy.wait_for_service(NODE + "/fit_scene", timeout=30)

    def fit(self, **request):
        return rospy.ServiceProxy(NODE + "/fit_scene", FitScene)(
            **{"robot_description": self.robot, "output": self.folder.output, "scene": self.folder.file("notch.yaml"), "clearance": 0.01,
               "samples": 200, **request})

    def assert_refused(self, word, **request):
        response = self.fit(**request)
        self.assertFalse(response.success)
        self.assertIn(word, response.message)
        self.assertEqual([], os.listdir(self.folder.results))

    def test_no_scene(self):
        self.assert_refused("scene", scene="")

    def test_scene_that_is_not_there(self):
        self.assert_refused("nowhere.yaml", scene=self.folder.file("nowhere.yaml"))

    def test_no_clearance(self):
        self.assert_refused("clearance", clearance=0)

    def test_negative_samples(self):
        self.assert_refused("samples", samples=-1)

    def test_fits(self):
        response = self.fit()
        self.assertTrue(response.success, response.message)
        scene = json.loads(response.report)["scene"]
        self.assertEqual((0, 0), (scene["missed"], scene["phantom"]))
        self.assertEqual([("base", 2, ""), ("arm", 0, "box")], [(l["link"], l["hulls"], l["primitive"]) for l in scene["links"]])
        self.assertIn("against block", scene["links"][0]["reason"])
        self.assertIn('link1="base" link2="arm" reason="Adjacent"', response.srdf)
        with open(os.path.join(self.folder.output, "config", "small_disabled.srdf")) as file:
            self.assertEqual(response.srdf, file.read())
        with open(response.urdf_path) as file:
            self.assertEqual(response.robot_description, file.read())

    def test_shows_what_was_not_needed(self):
        with open(self.folder.file("empty.yaml"), "w") as file:
            file.write("bodies: []\n")
        self.fit(scene=self.folder.file("empty.yaml"))
        markers = rospy.wait_for_message(NODE + "/markers", MarkerArray, timeout=10).markers
        grey = [marker for marker in markers if marker.ns == "unneeded/base"]
        self.assertEqual(2, len(grey))
        self.assertEqual(1, len([marker for marker in markers if marker.ns == "hulls/base"]))


if __name__ == "__main__":
    rospy.init_node("fit_scene_test")
    rostest.rosrun("collision_hulls", "fit_scene", FitSceneTest)
