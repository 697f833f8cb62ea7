#!/usr/bin/python3
"""Hull trees that the node holds, cuts through them, and their validation. Tests src/ros/preview/link_previews.cpp."""
import threading
import unittest

import robots
import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from collision_hulls.msg import BuildAction, BuildGoal, LinkChoice, NodeState
from collision_hulls.srv import Build, Preview, Validate
from robots import NODE
from visualization_msgs.msg import Marker, MarkerArray

CONFIG = "default: {tolerance: 5mm, tree: 5mm}"


class Drawn:
    """The markers that a display has."""

    def __init__(self, topic):
        self.markers, self.lock = {}, threading.Lock()
        self.subscriber = rospy.Subscriber(NODE + topic, MarkerArray, self.take)

    def take(self, message):
        with self.lock:
            for marker in message.markers:
                if marker.action == Marker.DELETEALL:
                    self.markers.clear()
                elif marker.action == Marker.DELETE:
                    self.markers.pop((marker.ns, marker.id), None)
                else:
                    self.markers[marker.ns, marker.id] = marker

    def seen(self, kind, link):
        """Those with something to see; a blank marker is a triangle whose corners are one point."""
        with self.lock:
            return [marker for (ns, _), marker in self.markers.items()
                    if ns == f"{kind}/{link}" and (marker.mesh_resource or len({(p.x, p.y, p.z) for p in marker.points}) > 1)]


class PreviewTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = robots.Folder()
        cls.addClassCleanup(cls.folder.remove)
        cls.robot = cls.folder.small_robot()
        rospy.wait_for_service(NODE + "/preview", 30)
        cls.preview = staticmethod(rospy.ServiceProxy(NODE + "/preview", Preview))
        cls.build = staticmethod(rospy.ServiceProxy(NODE + "/build", Build))
        cls.validate = staticmethod(rospy.ServiceProxy(NODE + "/validate", Validate))
        cls.hulls, cls.chosen = Drawn("/hulls"), Drawn("/chosen")

    def setUp(self):
        built = self.build(robot_description=self.robot, config=CONFIG)
        self.assertTrue(built.success, built.message)

    def cut(self, link="base", show=False, **settings):
        answer = self.preview(links=[LinkChoice(link=link, max_vertices=64, **settings)], show=show)
        self.assertTrue(answer.success, answer.message)
        return answer.links[0]

    def test_a_build_is_certified_and_offers_steps(self):
        base, arm = self.preview().links
        self.assertEqual(("base", "arm"), (base.settings.link, arm.settings.link))
        self.assertEqual(("ok", True, 2, 12), (base.status, base.proved, base.hulls, arm.triangles))
        self.assertGreaterEqual(base.protrusion, base.protrusion_found)
        self.assertGreater(len(base.steps), 1)

    def test_a_cut_is_as_coarse_as_its_tolerance(self):
        self.assertEqual(2, self.cut(tolerance="1cm").hulls)
        coarse = self.cut(tolerance="10cm")
        self.assertEqual((1, False), (coarse.hulls, coarse.proved))
        self.assertTrue(0.02 < coarse.protrusion < 0.1, coarse.protrusion)

    def test_only_a_cut_that_is_shown_is_remembered(self):
        self.cut(tolerance="10cm")
        self.assertEqual(2, self.preview().links[0].hulls)
        self.cut(tolerance="10cm", show=True)
        self.assertEqual(1, self.preview().links[0].hulls)

    def test_what_is_shown_is_seen_with_its_edges_and_no_other(self):
        self.cut(tolerance="10cm", show=True)
        self.assertTrue(robots.wait_until(lambda: len(self.hulls.seen("hulls", "base")) == 1))
        self.assertTrue(robots.wait_until(lambda: len(self.chosen.seen("chosen", "base")) == 1))
        self.cut(link="arm", tolerance="10cm", show=True)
        self.assertTrue(robots.wait_until(lambda: self.chosen.seen("chosen", "arm") and not self.chosen.seen("chosen", "base")))
        self.cut(tolerance="5mm", show=True)
        self.assertTrue(robots.wait_until(lambda: len(self.hulls.seen("hulls", "base")) == 2))
        self.assertEqual(1, len(self.hulls.seen("hulls", "arm")))

    def test_keep_and_remove_have_no_hulls(self):
        self.assertEqual("kept", self.cut(action="keep").status)
        self.cut(action="remove", show=True)
        self.assertTrue(robots.wait_until(lambda: not self.hulls.seen("hulls", "base")))

    def test_primitives_are_counted_by_themselves(self):
        built = self.build(robot_description=self.robot, config="default: {tolerance: 5mm, shapes: box}")
        self.assertTrue(built.success, built.message)
        self.assertEqual([(0, 1), (0, 1)], [(link.hulls, link.primitives) for link in self.preview().links])

    def test_what_no_tree_has_is_unbuilt(self):
        for settings, reason in (({"tolerance": "1mm"}, "leaves of 5 mm, and 1 mm is asked for"), ({"method": "single_hull"}, "single_hull"), ({"effort": "best"}, "effort")):
            answer = self.cut(**settings)
            self.assertEqual("unbuilt", answer.status, settings)
            self.assertIn(reason, answer.reason)
            self.assertIn("build the link", answer.reason)

    def test_a_cut_without_a_limit_of_vertices_has_a_tree_of_its_own(self):
        unlimited = LinkChoice(link="base", tolerance="10cm", max_vertices=0)
        answer = self.preview(links=[unlimited]).links[0]
        self.assertEqual("unbuilt", answer.status)
        self.assertIn("max_vertices 64, and 0 (no limit) is asked for: build the link", answer.reason)
        built = self.build(robot_description=self.robot, config=CONFIG.replace("default: {", "default: {max_vertices: 0, "))
        self.assertTrue(built.success, built.message)
        self.assertEqual(1, self.preview(links=[unlimited]).links[0].hulls)

    def test_a_link_in_a_region_is_not_cut(self):
        region = "regions: [{link: base, half_space: {normal: [0, 0, 1], offset: 1}, keep_clear: true}]"
        built = self.build(robot_description=self.robot, config=f"{CONFIG}\n{region}")
        self.assertTrue(built.success, built.message)
        base, arm = self.preview().links
        self.assertEqual([0, 0, -1, -1], list(base.settings.regions[0].sides))
        self.assertFalse(arm.settings.regions)
        regions = base.settings.regions
        self.assertTrue(self.cut(tolerance="5mm", regions=regions).proved)
        self.assertEqual("unbuilt", self.cut(tolerance="10cm", regions=regions).status)
        self.assertFalse(self.cut(tolerance="5mm").proved, "what is proved is for the region")
        self.assertEqual(1, self.cut(link="arm", tolerance="10cm").hulls)
        self.assertIn("half_space", self.preview().config)

    def test_the_configuration_has_the_regions_of_the_last_build(self):
        region = "regions: [{link: base, half_space: {normal: [0, 0, 1], offset: 1}, keep_clear: true}]"
        built = self.build(robot_description=self.robot, config=f"{CONFIG}\n{region}", only=["base"])
        self.assertTrue(built.success, built.message)
        self.assertIn("half_space", self.preview().config)
        self.assertTrue(self.build(robot_description=self.robot, config=CONFIG, only=["base"]).success)
        self.assertNotIn("half_space", self.preview().config)

    def test_a_link_says_where_its_bodies_are(self):
        base = self.preview().links[0]
        self.assertTrue(base.low.x < base.high.x and base.low.y < base.high.y and base.low.z < base.high.z, base)

    def test_a_wrong_question_is_answered_with_a_message(self):
        for choice, word in ((LinkChoice(link="leg"), "leg"), (LinkChoice(link="base", method="best"), "best"), (LinkChoice(link="base", tolerance="5m"), "5m")):
            answer = self.preview(links=[choice])
            self.assertFalse(answer.success)
            self.assertIn(word, answer.message)

    def test_a_link_is_asked_for_once(self):
        choice = LinkChoice(link="base", tolerance="1cm", max_vertices=64)
        for answer in (self.preview(links=[choice, choice]), self.validate(only=["arm", "base", "base"])):
            self.assertFalse(answer.success)
            self.assertIn("link 'base' is named twice; name it once", answer.message)

    def test_a_build_of_one_link_leaves_the_others(self):
        self.cut(link="arm", tolerance="10cm", show=True)
        built = self.build(robot_description=self.robot, config="default: {method: bounding_box}", only=["base"])
        self.assertTrue(built.success, built.message)
        self.assertEqual(["base"], [link.settings.link for link in built.links])
        base, arm = self.preview().links
        self.assertEqual(("bounding_box", "0.1m"), (base.settings.method, arm.settings.tolerance))

    def test_a_validation_compares_what_is_known(self):
        found = self.validate()
        self.assertTrue(found.success, found.message)
        self.assertEqual((0, 0), (found.missed, found.phantom))
        self.assertIn("no collision missed, no false collision", found.message)
        one = self.validate(only=["base"])
        self.assertTrue(0 < one.queries < found.queries, one)
        self.assertIn("has no link 'leg': use some of base, arm, tip", self.validate(only=["leg"]).message)
        self.assertIn("whole names, and no expressions", self.validate(only=["b.*"]).message)

    def test_without_hulls_there_is_nothing_to_validate(self):
        self.cut(link="arm", action="remove", show=True)
        found = self.validate(only=["arm"])
        self.assertFalse(found.success)
        self.assertIn("~build", found.message)

    def test_a_wrong_build_is_refused_with_a_message(self):
        self.assertIn("only: robot 'small' has no link 'leg'", self.build(robot_description=self.robot, only=["leg"]).message)
        self.assertIn("line 1", self.build(robot_description=self.robot, config="links: {leg: keep}").message)

    def test_a_build_has_a_state_and_can_be_cancelled(self):
        states = []
        subscriber = rospy.Subscriber(NODE + "/state", NodeState, states.append)
        client = actionlib.ActionClient(NODE + "/build_action", BuildAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(30)))
        handle = client.send_goal(BuildGoal(robot_description=self.folder.slow_robot()))
        self.assertTrue(robots.wait_until(lambda: states and states[-1].job == "build" and states[-1].text))
        handle.cancel()
        self.assertTrue(robots.wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE))
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_goal_status(), handle.get_goal_status_text())
        self.assertTrue(robots.wait_until(lambda: states[-1].job == ""))
        subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("preview_test")
    rostest.rosrun("collision_hulls", "preview_test", PreviewTest)
