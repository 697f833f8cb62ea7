#!/usr/bin/python3
"""The markers: latched, complete, told apart by colour, and replaced by the next run."""
import unittest

import robots
import rospy
import rostest
from robots import NODE, decompose
from visualization_msgs.msg import Marker, MarkerArray


def latched_markers():
    """What a subscriber gets that comes late."""
    return rospy.wait_for_message(NODE + "/markers", MarkerArray, timeout=10).markers


class MarkersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = robots.Folder()
        cls.addClassCleanup(cls.folder.remove)

    def run_small_robot(self, **request):
        response = decompose(robot_description=self.folder.small_robot(), output=self.folder.output, **request)
        self.assertTrue(response.success, response.message)
        markers = latched_markers()
        self.assertEqual(Marker.DELETEALL, markers[0].action)
        return response, markers[1:]

    def test_one_marker_for_each_hull_and_mesh(self):
        response, markers = self.run_small_robot()
        for row in response.links:
            for kind, count in (("hulls", row.hulls), ("original", 1), ("worst", 2 if row.protrusion_found > 0 else 0)):
                of_kind = [marker for marker in markers if marker.ns == f"{kind}/{row.link}"]
                self.assertEqual(list(range(count)), [marker.id for marker in of_kind])
                self.assertTrue(all(marker.header.frame_id == row.link for marker in of_kind))
        self.assertEqual(len(markers), sum(row.hulls + 1 + (2 if row.protrusion_found > 0 else 0) for row in response.links))

    def test_triangles(self):
        response, markers = self.run_small_robot()
        lists = [marker for marker in markers if not marker.ns.startswith("worst/")]
        for marker in lists:
            self.assertEqual((Marker.TRIANGLE_LIST, True), (marker.type, marker.frame_locked))
            self.assertGreater(len(marker.points), 0)
            self.assertEqual(0, len(marker.points) % 3)
            self.assertEqual((1, 1, 1), (marker.scale.x, marker.scale.y, marker.scale.z))
        originals = {marker.ns: marker for marker in lists if marker.ns.startswith("original/")}
        for row in response.links:
            self.assertEqual(3 * row.triangles, len(originals["original/" + row.link].points))
        self.assertLess(originals["original/arm"].color.a, 1)

    def test_the_pose_is_the_elements_origin(self):
        _, markers = self.run_small_robot()
        heights = {marker.ns: marker.pose.position.z for marker in markers if not marker.ns.startswith("worst/")}
        self.assertEqual({"hulls/base": 0, "original/base": 0, "hulls/arm": 0.1, "original/arm": 0.1}, heights)
        tops = [point.z for marker in markers if marker.ns == "hulls/arm" for point in marker.points]
        self.assertAlmostEqual(0.03, max(tops), places=5)

    def test_colours(self):
        _, markers = self.run_small_robot()
        colours = [(m.color.r, m.color.g, m.color.b) for m in markers if m.ns.startswith("hulls/")]
        self.assertEqual(len(colours), len(set(colours)))
        self.assertTrue(all(max(colour) - min(colour) > 0.4 for colour in colours), colours)
        _, again = self.run_small_robot()
        self.assertEqual(colours, [(m.color.r, m.color.g, m.color.b) for m in again if m.ns.startswith("hulls/")])

    def test_worst_place(self):
        """One hull over the L: its slanted face lies furthest from the solid."""
        response, markers = self.run_small_robot(links=["base"], method="single_hull")
        sphere, arrow = (marker for marker in markers if marker.ns == "worst/base")
        self.assertEqual((Marker.SPHERE, Marker.ARROW), (sphere.type, arrow.type))
        place, nearest = arrow.points
        self.assertEqual((place.x, place.y, place.z), (sphere.pose.position.x, sphere.pose.position.y, sphere.pose.position.z))
        length = ((place.x - nearest.x) ** 2 + (place.y - nearest.y) ** 2 + (place.z - nearest.z) ** 2) ** 0.5
        self.assertAlmostEqual(response.links[0].protrusion_found, length, places=6)
        self.assertAlmostEqual(0.04, length, delta=0.002)
        self.assertAlmostEqual(0.06, place.x, delta=0.005)

    def test_a_run_that_writes_nothing_leaves_them(self):
        response, markers = self.run_small_robot()
        text = self.folder.small_robot().replace("bracket.obj", "no.obj").replace("box.stl", "no.stl")
        failed = decompose(robot_description=text, output=self.folder.output)
        self.assertFalse(failed.success)
        self.assertIn("nothing is written", failed.message)
        self.assertEqual(len(markers), len(latched_markers()) - 1)
        self.assertEqual(response.robot_description, rospy.get_param(NODE + "/robot_description"))

    def test_a_second_run_replaces_the_first(self):
        self.run_small_robot()
        _, markers = self.run_small_robot(links=["arm"])
        self.assertEqual({"arm"}, {marker.ns.split("/")[1] for marker in markers})


if __name__ == "__main__":
    rospy.init_node("markers_test")
    rostest.rosrun("collision_hulls", "markers_test", MarkersTest)
