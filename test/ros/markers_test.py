#!/usr/bin/python3
"""The markers: latched, complete, told apart by colour, and replaced by the next run."""
import subprocess
import unittest

import robots
import roslib.packages
import rospy
import rostest
from robots import NODE, decompose
from visualization_msgs.msg import Marker, MarkerArray

KINDS = ("hulls", "original", "worst", "labels")


def latched_markers(topic="markers"):
    """What a subscriber gets that comes late."""
    return rospy.wait_for_message(f"{NODE}/{topic}", MarkerArray, timeout=10).markers


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

    def test_every_link_has_its_markers(self):
        response, markers = self.run_small_robot()
        for row in response.links:
            worst = 3 if row.protrusion_found > 0 else 0  # sphere, arrow, text
            for kind, count in zip(KINDS, (row.hulls, 1, worst, 2)):
                of_kind = [marker for marker in markers if marker.ns == f"{kind}/{row.link}"]
                self.assertEqual(list(range(count)), [marker.id for marker in of_kind], kind)
                self.assertTrue(all(marker.header.frame_id == row.link for marker in of_kind))
        self.assertEqual({f"{kind}/{row.link}" for kind in KINDS for row in response.links if kind != "worst" or row.protrusion_found > 0},
                         {marker.ns for marker in markers})

    def test_every_display_has_a_topic(self):
        _, markers = self.run_small_robot(links=["base"], method="single_hull")
        parts = []
        for topic in ("hulls", "original", "protrusion", "labels", "unneeded", "segments", "scene"):
            part = latched_markers(topic)
            self.assertEqual(Marker.DELETEALL, part[0].action)
            parts += part[1:]
        self.assertEqual(markers, parts)
        self.assertEqual(1, len(latched_markers("progress")))  # the text is gone

    def test_triangles(self):
        response, markers = self.run_small_robot()
        lists = [marker for marker in markers if marker.ns.startswith(("hulls/", "original/"))]
        for marker in lists:
            self.assertEqual((Marker.TRIANGLE_LIST, True), (marker.type, marker.frame_locked))
            self.assertGreater(len(marker.points), 0)
            self.assertEqual(0, len(marker.points) % 3)
            self.assertEqual((1, 1, 1), (marker.scale.x, marker.scale.y, marker.scale.z))
        originals = {marker.ns: marker for marker in lists if marker.ns.startswith("original/")}
        for row in response.links:
            self.assertEqual(3 * row.triangles, len(originals["original/" + row.link].points))
        self.assertEqual(1, originals["original/arm"].color.a)
        self.assertTrue(all(marker.color.a < 1 for marker in lists if marker.ns.startswith("hulls/")))  # the original shows through

    def test_the_pose_is_the_elements_origin(self):
        _, markers = self.run_small_robot()
        heights = {marker.ns: marker.pose.position.z for marker in markers if marker.ns.startswith(("hulls/", "original/"))}
        self.assertEqual({"hulls/base": 0, "original/base": 0, "hulls/arm": 0.1, "original/arm": 0.1}, heights)
        tops = [point.z for marker in markers if marker.ns == "hulls/arm" for point in marker.points]
        self.assertAlmostEqual(0.03, max(tops), places=5)

    def test_colours(self):
        _, markers = self.run_small_robot()
        colours = {(m.ns, m.color.r, m.color.g, m.color.b) for m in markers if m.ns.startswith("hulls/")}
        self.assertEqual(len(colours), len([m for m in markers if m.ns.startswith("hulls/")]))
        self.assertTrue(all(max(colour[1:]) - min(colour[1:]) > 0.4 for colour in colours), colours)
        _, again = self.run_small_robot()
        self.assertEqual(colours, {(m.ns, m.color.r, m.color.g, m.color.b) for m in again if m.ns.startswith("hulls/")})

    def test_worst_place(self):
        """One hull over the L: its slanted face lies furthest from the solid."""
        response, markers = self.run_small_robot(links=["base"], method="single_hull")
        sphere, arrow, text = (marker for marker in markers if marker.ns == "worst/base")
        self.assertEqual((Marker.SPHERE, Marker.ARROW, Marker.TEXT_VIEW_FACING), (sphere.type, arrow.type, text.type))
        tail, place = arrow.points
        self.assertEqual((place.x, place.y, place.z), (sphere.pose.position.x, sphere.pose.position.y, sphere.pose.position.z))
        self.assertAlmostEqual(0.06, place.x, delta=0.005)
        self.assertGreater(tail.x + tail.y, place.x + place.y + 0.01)  # it comes from outside
        self.assertEqual(f"{1000 * response.links[0].protrusion_found:.3g} mm", text.text)
        self.assertAlmostEqual(0.04, response.links[0].protrusion_found, delta=0.002)

    def test_the_view_knows_the_robots_size(self):
        self.run_small_robot()
        view = rospy.get_param(NODE + "/view")
        self.assertEqual(("small", "base"), (view["robot"], view["frame"]))
        self.assertAlmostEqual(0.15, view["centre"][0], delta=0.02)  # the arm hangs on at 0.2 and is 0.1 long
        self.assertAlmostEqual(0.175, view["radius"], delta=0.02)

    def test_a_run_that_writes_nothing_leaves_them(self):
        response, markers = self.run_small_robot()
        text = self.folder.small_robot().replace("bracket.obj", "no.obj").replace("box.stl", "no.stl")
        failed = decompose(robot_description=text, output=self.folder.output)
        self.assertFalse(failed.success)
        self.assertIn("nothing was written", failed.message)
        self.assertEqual(len(markers), len(latched_markers()) - 1)
        self.assertEqual(response.robot_description, rospy.get_param(NODE + "/robot_description"))

    def test_a_second_run_replaces_the_first(self):
        self.run_small_robot()
        _, markers = self.run_small_robot(links=["arm"])
        self.assertEqual({"arm"}, {marker.ns.split("/")[1] for marker in markers})

    def test_the_original_is_there_while_a_run_goes_on(self):
        """A node that has no result yet: it shows the original as rviz can read it, and how far the work is."""
        rospy.set_param("/robot_description", self.folder.slow_robot())
        self.addCleanup(rospy.delete_param, "/robot_description")
        texts = []
        rospy.Subscriber("/early/progress", MarkerArray, lambda array: texts.extend(marker.text for marker in array.markers if marker.text))
        program = roslib.packages.find_node("collision_hulls", "collision_hulls_node")[0]
        node = subprocess.Popen([program, "__name:=early", "_auto:=true", "_cache:=false", "_output:=" + self.folder.output, *robots.ROOTS])
        self.addCleanup(node.wait, 20)
        self.addCleanup(node.terminate)
        originals = []
        rospy.Subscriber("/early/original", MarkerArray, lambda array: originals.append([marker.type for marker in array.markers[1:]]))
        self.assertTrue(robots.wait_until(lambda: [Marker.MESH_RESOURCE] * 15 in originals, 20), originals)
        self.assertFalse(rospy.has_param("/early/robot_description"))
        self.assertTrue(robots.wait_until(lambda: any("of 15 meshes" in text for text in texts), 60), texts)


if __name__ == "__main__":
    rospy.init_node("markers_test")
    rostest.rosrun("collision_hulls", "markers_test", MarkersTest)
