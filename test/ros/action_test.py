#!/usr/bin/python3
"""The actions: result, feedback, cancel in the middle, and other requests meanwhile."""
import os
import unittest

import robots
import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from collision_hulls.msg import (DecomposeAction, DecomposeActionFeedback, DecomposeGoal, FitSceneAction, FitSceneActionFeedback,
                                 FitSceneGoal)
from robots import NODE, decompose


class ActionTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Not a SimpleActionClient: it drops what comes before its send_goal() has returned, as it may for a small robot.
        cls.client = actionlib.ActionClient(NODE + "/decompose_action", DecomposeAction)
        cls.fit_client = actionlib.ActionClient(NODE + "/fit_scene_action", FitSceneAction)
        for client in (cls.client, cls.fit_client):
            if not client.wait_for_server(rospy.Duration(30)):
                raise RuntimeError("no action server")
        # Not the clients' callbacks: a client drops what comes after the result, as the last of another topic may.
        cls.received = []  # (goal's id, feedback)
        topics = (("/decompose_action", DecomposeActionFeedback), ("/fit_scene_action", FitSceneActionFeedback))
        cls.subscribers = [rospy.Subscriber(NODE + topic + "/feedback", kind, cls.receive, queue_size=None) for topic, kind in topics]
        if not robots.wait_until(lambda: all(each.get_num_connections() for each in cls.subscribers)):
            raise RuntimeError("no feedback topics")

    @classmethod
    def receive(cls, message):
        cls.received.append((message.status.goal_id.id, message.feedback))

    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        self.goals = set()

    @property
    def feedback(self):
        """Of this test's goals."""
        return [feedback for goal, feedback in self.received if goal in self.goals]

    def send_goal(self, client, goal):
        handle = client.send_goal(goal)
        self.goals.add(handle.comm_state_machine.action_goal.goal_id.id)
        return handle

    def send(self, robot, **fields):
        """The handle of a new goal."""
        goal = DecomposeGoal(robot_description=robot, output=self.folder.output, **fields)
        return self.send_goal(self.client, goal)

    def send_fit(self, robot, **fields):
        """The same to the other action: a scene that the robot is clear of."""
        with open(self.folder.file("empty.yaml"), "w", encoding="utf-8") as file:
            file.write("name: nothing\nbodies: []\n")
        goal = FitSceneGoal(robot_description=robot, output=self.folder.output, scene=self.folder.file("empty.yaml"), clearance=0.01,
                            samples=200, **fields)
        return self.send_goal(self.fit_client, goal)

    def send_slow(self, send=None):
        """The handle of a goal that is still being worked on when this returns."""
        handle = (send or self.send)(self.folder.slow_robot())
        self.assertTrue(robots.wait_until(lambda: self.feedback), "no feedback")
        return handle

    def assert_ends(self, state, handle):
        """The result, once it is there."""
        self.assertTrue(robots.wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE), "no end")
        self.assertEqual(state, handle.get_goal_status(), handle.get_goal_status_text())
        return handle.get_result()

    def test_rubbish_is_aborted(self):
        result = self.assert_ends(GoalStatus.ABORTED, self.send("rubbish"))
        self.assertFalse(result.success)
        self.assertIn("XML", result.message)

    def test_result_is_the_services(self):
        result = self.assert_ends(GoalStatus.SUCCEEDED, self.send(self.folder.small_robot()))
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output)
        self.assertTrue(result.success)
        self.assertEqual(response.robot_description, result.robot_description)
        self.assertEqual(response.urdf_path, result.urdf_path)
        self.assertEqual([(row.link, row.hulls, row.protrusion) for row in response.links],
                         [(row.link, row.hulls, row.protrusion) for row in result.links])

    def assert_feedback(self, stages):
        """It goes from 0 to 1 through these stages."""
        self.assertTrue(robots.wait_until(lambda: self.feedback and self.feedback[-1].fraction == 1, 10), "no last feedback")
        fractions = [step.fraction for step in self.feedback]
        self.assertEqual(sorted(fractions), fractions)
        self.assertEqual(0, fractions[0])
        seen = [step.stage for step in self.feedback]
        self.assertEqual(stages, [stage for i, stage in enumerate(seen) if i == 0 or seen[i - 1] != stage])
        self.assertEqual({2}, {step.total for step in self.feedback})
        self.assertEqual("reading 2 meshes", self.feedback[0].text)
        self.assertEqual({"arm", "base"}, {step.link for step in self.feedback if step.link})

    def test_configuration(self):
        result = self.assert_ends(GoalStatus.SUCCEEDED, self.send(self.folder.small_robot(), config="links: {arm: remove}"))
        self.assertEqual(["ok", "removed"], [row.status for row in result.links])

    def test_feedback(self):
        result = self.assert_ends(GoalStatus.SUCCEEDED, self.send(self.folder.small_robot()))
        self.assert_feedback(["read", "decompose", "validate"])
        self.assertEqual(sum(row.hulls for row in result.links), self.feedback[-1].hulls)

    def test_feedback_from_within_a_mesh(self):
        handle = self.send_slow()
        self.assertTrue(robots.wait_until(lambda: any(step.done == 0 and step.fraction > 0 for step in self.feedback)), "no such feedback")
        handle.cancel()
        self.assert_ends(GoalStatus.PREEMPTED, handle)

    def test_fits_to_a_scene(self):
        result = self.assert_ends(GoalStatus.SUCCEEDED, self.send_fit(self.folder.small_robot()))
        self.assertIn('"scene"', result.report)
        self.assertIn("Adjacent", result.srdf)
        self.assertIn("'nothing'", result.table)
        self.assert_feedback(["read", "decompose", "fit", "certify", "validate"])

    def test_cancels_a_fit(self):
        handle = self.send_slow(self.send_fit)
        handle.cancel()
        result = self.assert_ends(GoalStatus.PREEMPTED, handle)
        self.assertFalse(result.success)
        self.assertIn("cancelled", result.message)
        self.assertEqual([], os.listdir(self.folder.results))

    def test_a_fit_keeps_others_out(self):
        handle = self.send_slow(self.send_fit)
        self.assert_ends(GoalStatus.REJECTED, self.send(self.folder.small_robot()))
        handle.cancel()
        self.assert_ends(GoalStatus.PREEMPTED, handle)

    def test_cancel_in_the_middle(self):
        handle = self.send_slow()
        handle.cancel()
        result = self.assert_ends(GoalStatus.PREEMPTED, handle)
        self.assertFalse(result.success)
        self.assertEqual("cancelled; nothing was written", result.message)
        self.assertEqual([], os.listdir(self.folder.results))
        self.assertTrue(decompose(robot_description=self.folder.small_robot(), output=self.folder.output).success)

    def test_others_meanwhile(self):
        handle = self.send_slow()
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output)
        self.assertFalse(response.success)
        self.assertRegex(response.message, r"^busy: working on goal '.+' of decompose_action; try again when it is done$")
        second = self.send(self.folder.small_robot())
        self.assertTrue(self.assert_ends(GoalStatus.REJECTED, second).message.startswith("busy: "))
        self.assertTrue(robots.answers())
        self.assertEqual(GoalStatus.ACTIVE, handle.get_goal_status())
        handle.cancel()
        self.assert_ends(GoalStatus.PREEMPTED, handle)

    def test_next_goal_follows_at_once(self):
        for _ in range(5):
            self.assert_ends(GoalStatus.SUCCEEDED, self.send(self.folder.small_robot(), links=["arm"]))


if __name__ == "__main__":
    rospy.init_node("action_test")
    rostest.rosrun("collision_hulls", "action_test", ActionTest)
