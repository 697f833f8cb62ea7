#!/usr/bin/python3
"""The action: result, feedback, cancel in the middle, and other requests meanwhile."""
import os
import unittest

import robots
import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from collision_hulls.msg import DecomposeAction, DecomposeGoal
from robots import NODE, decompose


class ActionTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        self.feedback = []
        self.client = self.new_client()

    def new_client(self):
        client = actionlib.SimpleActionClient(NODE + "/decompose_action", DecomposeAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(30)))
        return client

    def send(self, robot, **fields):
        goal = DecomposeGoal(robot_description=robot, output=self.folder.output, **fields)
        self.client.send_goal(goal, feedback_cb=self.feedback.append)

    def send_slow(self):
        """Sends a goal that is still being worked on when this returns."""
        self.send(self.folder.slow_robot())
        self.assertTrue(robots.wait_until(lambda: self.feedback), "no feedback")

    def cancel(self):
        self.client.cancel_goal()
        self.assertTrue(self.client.wait_for_result(rospy.Duration(10)))
        self.assertEqual(GoalStatus.PREEMPTED, self.client.get_state())

    def test_rubbish_is_aborted(self):
        self.send("rubbish")
        self.assertTrue(self.client.wait_for_result(rospy.Duration(10)))
        self.assertEqual(GoalStatus.ABORTED, self.client.get_state())
        self.assertFalse(self.client.get_result().success)
        self.assertIn("XML", self.client.get_result().message)

    def test_result_is_the_services(self):
        self.send(self.folder.small_robot())
        self.assertTrue(self.client.wait_for_result(rospy.Duration(60)))
        self.assertEqual(GoalStatus.SUCCEEDED, self.client.get_state())
        result = self.client.get_result()
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output)
        self.assertTrue(result.success)
        self.assertEqual(response.robot_description, result.robot_description)
        self.assertEqual(response.urdf_path, result.urdf_path)
        self.assertEqual([(row.link, row.hulls, row.protrusion) for row in response.links],
                         [(row.link, row.hulls, row.protrusion) for row in result.links])

    def test_feedback(self):
        self.send(self.folder.small_robot())
        self.assertTrue(self.client.wait_for_result(rospy.Duration(60)))
        steps = [feedback for feedback in self.feedback if feedback.stage == "decompose"]
        self.assertEqual([1, 2], [step.done for step in steps])
        self.assertEqual([2, 2], [step.total for step in steps])
        self.assertEqual(["arm", "base"], sorted(step.link.split()[0] for step in steps))
        self.assertEqual(sum(row.hulls for row in self.client.get_result().links), steps[-1].hulls)

    def test_cancel_in_the_middle(self):
        self.send_slow()
        self.cancel()
        self.assertFalse(self.client.get_result().success)
        self.assertEqual([], os.listdir(self.folder.results))
        self.assertTrue(decompose(robot_description=self.folder.small_robot(), output=self.folder.output).success)

    def test_others_meanwhile(self):
        self.send_slow()
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output)
        self.assertFalse(response.success)
        self.assertTrue(response.message.startswith("busy: "), response.message)
        second = self.new_client()
        second.send_goal_and_wait(DecomposeGoal(robot_description=self.folder.small_robot()), rospy.Duration(10))
        self.assertEqual(GoalStatus.REJECTED, second.get_state())
        self.assertTrue(second.get_goal_status_text().startswith("busy: "), second.get_goal_status_text())
        self.assertTrue(robots.answers())
        self.assertEqual(GoalStatus.ACTIVE, self.client.get_state())
        self.cancel()

    def test_next_goal_follows_at_once(self):
        for _ in range(5):
            self.send(self.folder.small_robot(), links=["arm"])
            self.assertTrue(self.client.wait_for_result(rospy.Duration(60)))
            self.assertEqual(GoalStatus.SUCCEEDED, self.client.get_state(), self.client.get_goal_status_text())


if __name__ == "__main__":
    rospy.init_node("action_test")
    rostest.rosrun("collision_hulls", "action_test", ActionTest)
