#!/usr/bin/python3
# Also tests src/ros/live_scene.cpp.
"""The service that fits a robot to a scene: what it makes, what it shows, and rubbish."""
import importlib.util
import json
import os
import threading
import unittest

import robots
import rospy
import rostest
from collision_hulls.srv import FitScene
from robots import NODE
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

# A block in the notch of the small robot's bracket: within its hull, and 2 cm from it.
BLOCK = "name: notch\nbodies:\n- {name: block, box: [0.02, 0.02, 0.02], pose: {xyz: [0.05, 0.05, 0.025]}}\n"


class UnknownOctomap(String):
    """What the master takes for an octomap."""
    _type = "octomap_msgs/Octomap"


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
        nowhere = self.folder.file("nowhere.yaml")
        self.assert_refused(f"scene: '{nowhere}' does not exist; check the path", scene=nowhere)

    def test_no_clearance(self):
        self.assert_refused("clearance", clearance=0)

    def test_a_path_in_place_of_the_srdf(self):
        self.assert_refused("srdf is the path '/tmp/small.srdf': send the text of the file", srdf="/tmp/small.srdf")

    def test_joints_that_do_not_move(self):
        self.assert_refused("joints 'wrist' matches no joint with room between its limits", joints="wrist")
        self.assert_refused("at 'elbow' is invalid", at=["elbow"])
        self.assert_refused("joint 'elbow' cannot be set", at=["elbow=1"])

    def test_configuration(self):
        self.assert_refused("method 'acd' of link 'arm'", config="links: {arm: {method: acd}}")
        response = self.fit(config="links: {arm: keep}")
        self.assertTrue(response.success, response.message)
        self.assertEqual(["ok", "kept"], [row.status for row in response.links])
        self.assertIn("<robot", response.srdf)

    def test_parameters_of_the_other_job_do_not_matter(self):
        for others in {"method": "hacd", "segments": True}, {"padding": "1cm", "time_limit": "9s"}, {"tree": "1cm"}, {"shapes": "sphere"}:
            for name, value in others.items():
                rospy.set_param(f"{NODE}/{name}", value)
            response = self.fit()
            for name in others:
                rospy.delete_param(f"{NODE}/{name}")
            self.assertTrue(response.success, f"{others}: {response.message}")

    def test_brief(self):
        response = self.fit(brief=True)
        self.assertEqual(("", "", ""), (response.robot_description, response.report, response.srdf))
        self.assertIn("check in the scene: ", response.table)
        self.assertRegex(response.message, r"robot 'small': (\d+ hulls? and )?\d primitives? for 2 meshes; largest protrusion ")

    def test_base_that_is_longer_than_a_path(self):
        self.assert_refused("base: ", base="/a" * 2049)

    def test_negative_samples(self):
        self.assert_refused("samples", samples=-1)

    def test_scene_that_nobody_publishes(self):
        self.assert_refused("has no publisher", scene="topic:/nowhere")

    def test_scene_of_another_type(self):
        publisher = rospy.Publisher("/said", String, queue_size=1)
        self.addCleanup(publisher.unregister)
        self.assert_refused("is a std_msgs/String", scene="topic:/said")

    @unittest.skipIf(importlib.util.find_spec("octomap_msgs"), "octomap_msgs is installed")
    def test_scene_of_a_package_that_was_not_there(self):
        publisher = rospy.Publisher("/map", UnknownOctomap, queue_size=1)
        self.addCleanup(publisher.unregister)
        self.assert_refused("install octomap_msgs", scene="topic:/map")

    @unittest.skipUnless(importlib.util.find_spec("octomap_msgs"), "octomap_msgs is not installed")
    def test_fits_to_an_octomap(self):
        from octomap_msgs.msg import Octomap
        message = Octomap(binary=True, id="OcTree", resolution=0.25, data=[0, -128])
        message.header.frame_id = "base"
        publisher = rospy.Publisher("/real_map", Octomap, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(message)
        response = self.fit(scene="topic:/real_map")
        self.assertTrue(response.success, response.message)
        scene = json.loads(response.report)["scene"]
        self.assertIn("octomap/1", scene["scene_contact"])

    @unittest.skipUnless(importlib.util.find_spec("moveit_msgs"), "moveit_msgs is not installed")
    def test_fits_to_a_planning_scene(self):
        from moveit_msgs.srv import GetPlanningScene, GetPlanningSceneResponse
        from moveit_msgs.msg import CollisionObject
        from shape_msgs.msg import SolidPrimitive
        from geometry_msgs.msg import Point, Pose, Quaternion
        block = CollisionObject(id="block", primitives=[SolidPrimitive(type=SolidPrimitive.BOX, dimensions=[0.02] * 3)])
        block.header.frame_id = "base"
        block.primitive_poses.append(Pose(Point(0.05, 0.05, 0.025), Quaternion(0, 0, 0, 1)))
        answer = GetPlanningSceneResponse()
        answer.scene.world.collision_objects.append(block)
        service = rospy.Service("/get_planning_scene", GetPlanningScene, lambda request: answer)
        self.addCleanup(service.shutdown)
        response = self.fit(scene="service:/get_planning_scene")
        self.assertTrue(response.success, response.message)
        self.assertIn("against block", json.loads(response.report)["scene"]["links"][0]["reason"])

    @unittest.skipUnless(importlib.util.find_spec("moveit_msgs"), "moveit_msgs is not installed")
    def test_a_planning_scene_that_never_comes(self):
        from moveit_msgs.srv import GetPlanningScene
        ended = threading.Event()
        service = rospy.Service("/silent_planning_scene", GetPlanningScene, lambda request: ended.wait(60) and None)
        self.addCleanup(service.shutdown)
        self.addCleanup(ended.set)
        self.assert_refused("did not answer within 10 s", scene="service:/silent_planning_scene")

    def test_configurations_that_nobody_publishes(self):
        self.assert_refused("has no publisher", configurations="topic:/nowhere")

    def test_configurations_of_a_bag_that_is_not_there(self):
        self.assert_refused("nowhere.bag", configurations=self.folder.file("nowhere.bag"))

    def test_configurations_of_a_topic(self):
        publisher = rospy.Publisher("/states", JointState, queue_size=10)
        self.addCleanup(publisher.unregister)
        timer = rospy.Timer(rospy.Duration(0.02), lambda event: publisher.publish(JointState(name=["to_arm"], position=[0.5])))
        self.addCleanup(timer.shutdown)
        response = self.fit(configurations="topic:/states 1")
        self.assertTrue(response.success, response.message)
        scene = json.loads(response.report)["scene"]
        self.assertTrue(scene["given"])
        self.assertGreater(scene["samples"], 5)

    def test_fits(self):
        response = self.fit()
        self.assertTrue(response.success, response.message)
        scene = json.loads(response.report)["scene"]
        self.assertEqual((0, 0), (scene["missed"], scene["phantom"]))
        self.assertEqual([("base", 0, "2 boxes"), ("arm", 0, "box")], [(l["link"], l["hulls"], l["primitive"]) for l in scene["links"]])
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
