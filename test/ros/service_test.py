#!/usr/bin/python3
# Also tests src/ros/collision_hulls_node.cpp, src/ros/node.cpp and src/ros/parameters.cpp.
"""The service: what it makes, its options, rubbish, and two callers at once."""
import contextlib
import io
import json
import os
import re
import shutil
import threading
import unittest
from unittest import mock

import robots
import rospy
import rostest
from collision_hulls.msg import LinkReport
from collision_hulls.srv import DecomposeRequest
from robots import NODE, decompose


class ServiceTest(unittest.TestCase):
    def setUp(self):
        self.folder = robots.Folder()
        self.addCleanup(self.folder.remove)
        self.robot = self.folder.small_robot()

    def set_parameter(self, name, value):
        rospy.set_param(name, value)
        self.addCleanup(lambda: rospy.has_param(name) and rospy.delete_param(name))

    def decompose(self, **request):
        return decompose(**{"robot_description": self.robot, "output": self.folder.output, **request})

    def decompose_well(self, **request):
        response = self.decompose(**request)
        self.assertTrue(response.success, response.message)
        return response

    def assert_refused(self, words, **request):
        response = self.decompose(**request)
        self.assertFalse(response.success)
        for word in words:
            self.assertIn(word, response.message)
        self.assertEqual("", response.urdf_path)
        self.assertTrue(robots.answers())
        self.assertEqual([], os.listdir(self.folder.results))

    # Refusals first: each leaves the node alive and nothing behind.

    def test_no_description_at_all(self):
        self.assert_refused(["robot_description"], robot_description="")

    def test_not_xml(self):
        self.assert_refused(["XML"], robot_description="rubbish")

    def test_a_path_in_place_of_the_text(self):
        for path in (self.folder.file("robot.urdf"), "robot.urdf", "robot.xacro\n"):
            self.assert_refused([path.strip(), "send the text of the URDF, and the path as `base`"], robot_description=path)

    def test_a_parameter_that_is_no_description(self):
        self.set_parameter("/robot_description", "/tmp/robot.urdf")
        self.assert_refused(["/tmp/robot.urdf", "set the parameter to the text of the URDF"], robot_description="")
        rospy.set_param("/robot_description", "")
        self.assert_refused(["the parameter /robot_description is empty"], robot_description="")

    def test_not_a_robot(self):
        self.assert_refused(["robot"], robot_description="<sofa/>")

    def test_no_links(self):
        self.assert_refused(["link"], robot_description='<robot name="none"/>')

    def test_negative_tolerance(self):
        self.assert_refused(["tolerance", "-0.5"], tolerance=-0.5)

    def test_tolerance_that_is_no_number(self):
        self.assert_refused(["tolerance", "nan"], tolerance=float("nan"))

    def test_unknown_method(self):
        self.assert_refused(["'magic'", "hacd"], method="magic")

    def test_unknown_link(self):
        self.assert_refused(["'leg': use some of base, arm, tip"], links=["base", "leg"])

    def test_link_names_are_no_expressions(self):
        self.assert_refused(["links: ", "'b.*'", "whole names, and no expressions", "base, arm, tip"], links=["b.*"])

    def test_base_that_is_longer_than_a_path(self):
        self.assert_refused(["base: ", "4096"], base="/a" * 2049)

    def test_output_below_a_file(self):
        self.assert_refused(["bracket.obj"], output=self.folder.file("bracket.obj/made"))

    def test_output_that_is_something_else(self):
        self.assert_refused([self.folder.path], output=self.folder.path)

    def test_parameter_of_the_wrong_type(self):
        self.set_parameter(NODE + "/max_hulls", "many")
        self.assert_refused(["max_hulls is 'many', not a whole number"])
        self.set_parameter(NODE + "/max_hulls", 1.5)
        self.assert_refused(["max_hulls is '1.5', not a whole number"])
        self.set_parameter(NODE + "/max_hulls", -3)
        self.assert_refused(["max_hulls '-3' is invalid"])

    def test_one_bad_link_among_good_ones(self):
        os.remove(self.folder.file("box.stl"))
        response = self.decompose()
        self.assertFalse(response.success)
        self.assertIn("box.stl", response.message)
        self.assertEqual([("base", "ok"), ("arm", "failed")], [(row.link, row.status) for row in response.links])
        self.assertTrue(os.path.isfile(response.urdf_path))

    def test_remedies_are_the_node_s(self):
        response = self.decompose(robot_description=robots.chain("small", [("base", robots.link("base", "package://no_such/base.stl"))]))
        remedy = "say where it is with the start-up parameter ~package_path no_such=DIR"
        self.assertIn(remedy, response.message)
        self.assertIn(remedy, response.links[0].reason)
        self.set_parameter(NODE + "/validate", False)
        self.assertIn("check: skipped (~validate false)", self.decompose_well().table)

    def test_configuration_with_a_mistake(self):
        self.assert_refused(["'config', line 2", "'tolerence'", "did you mean 'tolerance'?"], config="links:\n  arm: {tolerence: 1mm}")
        self.assert_refused(["'config', line 1", "'leg' matches no link"], config="links: {leg: keep}")
        self.set_parameter(NODE + "/config", "links: [arm]")
        self.assert_refused([NODE + "/config", "links is a list"])
        self.set_parameter(NODE + "/config", {"links": {}})
        self.assert_refused(["config is not a text"])

    # An expression that backtracks for ever, and a long name: the node answers all the same.
    def test_configuration_that_is_hostile(self):
        self.assert_refused(["matches no link"], config="links: {\"(a|a)*b\": keep}", robot_description=self.robot.replace("arm", "a" * 900))
        self.assert_refused(["brackets"], config="links: " + "[" * 100000)

    # What it makes.

    def test_the_document_s_caller(self):
        """The Python in doc/ros.md, whose node is this one."""
        page = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../doc/ros.md")
        with open(page, encoding="utf-8") as file:
            callers = re.findall(r"^```python\n(.*?)^```$", file.read(), flags=re.M | re.S)
        self.assertEqual(1, len(callers))
        self.set_parameter("/robot_description", self.robot)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed), mock.patch.object(rospy, "init_node"):
            names = {}
            exec(callers[0], names)  # pylint: disable=exec-used
        self.addCleanup(shutil.rmtree, os.path.dirname(os.path.dirname(names["answer"].urdf_path)))
        self.assertEqual(["base", "arm"], [line.split()[0] for line in printed.getvalue().splitlines()])
        self.assertIn("file://", names["description"])

    def test_configuration(self):
        config = "default: {tolerance: 5mm}\nlinks: {arm: keep, base: {max_hulls: 1}}"
        response = self.decompose_well(config=config)
        self.assertEqual([("base", "degraded", 1), ("arm", LinkReport.KEPT, 0)], [(row.link, row.status, row.hulls) for row in response.links])
        self.assertEqual(0.005, response.links[0].tolerance)
        self.assertEqual(0.002, self.decompose_well(config=config, tolerance=0.002).links[0].tolerance)  # a field counts before the default
        with open(os.path.join(self.folder.output, "config/small_hulls.yaml"), encoding="utf-8") as file:
            self.assertEqual(response.links[1].status, self.decompose_well(config=file.read()).links[1].status)

    def test_an_option_without_a_field(self):
        report = json.loads(self.decompose_well(config="default: {close_openings: 5cm}").report)
        self.assertEqual({0.05}, {link["close_openings"] for link in report["links"]})

    # As a launch file's robot_description comes: without its file.
    def test_its_own_output_is_noted(self):
        config, again = "output: {uri: file}", "the output of an earlier run: bounds are measured from its hulls"
        first = self.decompose_well(config=config)
        self.assertNotIn(again, first.table)
        second = self.decompose_well(config=config, robot_description=first.robot_description, output=self.folder.output + "_2")
        self.assertIn(again, second.table)

    def test_configuration_of_the_node(self):
        self.set_parameter(NODE + "/config", "links: {base: remove}")
        self.assertEqual(LinkReport.REMOVED, self.decompose_well().links[0].status)
        self.assertEqual("ok", self.decompose_well(config="seed: 2").links[0].status)  # the request's takes its place

    def test_models(self):
        response = self.decompose_well(config="models: {planning: 10cm, contact: 1mm}")
        self.assertTrue(response.urdf_path.endswith("/urdf/small.urdf"), response.urdf_path)
        self.assertEqual("urdf/small_contact.urdf", json.loads(response.report)["models"][0]["urdf"])

    def test_small_robot(self):
        response = self.decompose_well()
        self.assertEqual([("base", "ok", 20), ("arm", "ok", 12)], [(row.link, row.status, row.triangles) for row in response.links])
        self.assertGreaterEqual(response.links[0].hulls, 2)
        self.assertEqual([0, 0], [row.uncovered for row in response.links])
        with open(response.urdf_path, encoding="utf-8") as file:
            self.assertEqual(file.read(), response.robot_description)
        self.assertEqual(response.robot_description, rospy.get_param(NODE + "/robot_description"))
        self.assertIn("<collision", response.robot_description)
        with open(os.path.join(self.folder.output, "report.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["links"], json.loads(response.report)["links"])

    def test_totals_and_table(self):
        response = self.decompose_well()
        totals = response.totals
        self.assertEqual((2, 2, 32, 0, 0), (totals.links, totals.meshes, totals.triangles, totals.degraded, totals.failed))
        self.assertEqual(sum(row.hulls for row in response.links), totals.hulls)
        self.assertEqual(sum(row.hull_vertices for row in response.links), totals.hull_vertices)
        worst = max(response.links, key=lambda row: row.protrusion)
        self.assertEqual((worst.link, worst.protrusion), (totals.worst_link, totals.protrusion))
        self.assertIn("bracket.obj", response.table)
        self.assertIn(f"robot 'small': {totals.hulls} hulls for 2 meshes; largest protrusion ", response.message)
        self.assertIn("Written to " + self.folder.output, response.message)

    def test_worst_point(self):
        row = self.decompose_well(method="single_hull", links=["base"]).links[0]
        self.assertEqual(LinkReport.DEGRADED, row.status)
        apart = sum((getattr(row.worst, axis) - getattr(row.worst_nearest, axis))**2 for axis in "xyz")**0.5
        self.assertGreater(apart, 0.01)
        self.assertAlmostEqual(row.protrusion_found, apart, places=6)

    def test_brief(self):
        response = self.decompose_well(brief=True)
        self.assertEqual(("", ""), (response.robot_description, response.report))
        self.assertIn("bracket.obj", response.table)
        self.assertEqual(2, len(response.links))
        self.assertTrue(os.path.isfile(response.urdf_path))

    def test_description_from_the_parameter(self):
        self.set_parameter("/robot_description", self.robot)
        self.assertEqual(2, len(self.decompose_well(robot_description="").links))

    def test_paths_relative_to_the_base(self):
        self.set_parameter(NODE + "/base", self.folder.file("small.urdf"))
        with open(self.folder.file("small.urdf"), "w", encoding="utf-8") as file:
            file.write(self.folder.small_robot(relative=True))
        robot = self.folder.small_robot(relative=True)
        self.assertFalse(decompose(robot_description=robot).success, "it may be from anywhere")
        self.decompose_well(robot_description=robot, base=self.folder.file("small.urdf"))
        self.set_parameter("/robot_description", robot)
        self.decompose_well(robot_description="")

    def test_package_paths(self):
        robot = robots.chain("packaged", [("finger", robots.link("finger", "package://collision_hulls/meshes/finger.stl"))])
        self.assertEqual("finger", self.decompose_well(robot_description=robot, tolerance=0, relative_tolerance=0.05).links[0].link)

    # Options: the request's before the parameters'.

    def test_links(self):
        self.assertEqual(["arm"], [row.link for row in self.decompose_well(links=["arm", "tip"]).links])

    def test_method(self):
        self.assertEqual([1, 1], [row.hulls for row in self.decompose_well(method=DecomposeRequest.SINGLE_HULL).links])

    def test_tolerance(self):
        self.assertEqual(0.004, self.decompose_well(tolerance=0.004).links[0].tolerance)
        diagonal = (0.1**2 + 0.05**2 + 0.03**2) ** 0.5
        self.assertAlmostEqual(0.02 * diagonal, self.decompose_well(relative_tolerance=0.02).links[1].tolerance, places=8)
        for metres in (0.001, 0.004):
            both = self.decompose_well(tolerance=metres, relative_tolerance=0.02)
            self.assertAlmostEqual(min(metres, 0.02 * diagonal), both.links[1].tolerance, places=8)

    def test_tolerance_parameter(self):
        for value, expected in (("3mm", 0.003), (0.002, 0.002), (1, 1.0), ("3mm,50%", 0.003)):
            self.set_parameter(NODE + "/tolerance", value)
            self.assertEqual(expected, self.decompose_well().links[0].tolerance)
        self.assertEqual(0.004, self.decompose_well(tolerance=0.004).links[0].tolerance)

    def test_other_parameters(self):
        for name, value in (("method", "bounding_box"), ("links", "b.*"), ("format", "obj"), ("uri", "relative"), ("validate", False),
                            ("jobs", 1), ("seed", 7), ("max_vertices", 32), ("effort", "best")):
            self.set_parameter(f"{NODE}/{name}", value)
        self.set_parameter(NODE + "/output", self.folder.output)
        response = self.decompose_well(output="")
        self.assertEqual([("base", 1, 8)], [(row.link, row.hulls, row.hull_vertices) for row in response.links])
        self.assertEqual(["report.json"], [name for name in os.listdir(self.folder.output) if name == "report.json"])
        self.assertIn(".obj", response.robot_description)
        self.assertNotIn("package://", response.robot_description)
        self.assertEqual(7, json.loads(response.report)["seed"])

    # Two at once.

    def test_second_caller_is_told_busy(self):
        slow = robots.chain("slow", [("slow", robots.link("slow", self.folder.uri("torus.obj")))])
        robots.write_obj(self.folder.file("torus.obj"), robots.torus(0.1, 0.03, 60, 40))
        first = []
        caller = threading.Thread(target=lambda: first.append(self.decompose(robot_description=slow)))
        caller.start()
        refusals = []
        while caller.is_alive():
            second = self.decompose(output=self.folder.file("results/second"))
            self.assertTrue(robots.answers())
            if not second.success:
                refusals.append(second.message)
        caller.join()
        self.assertTrue(first[0].success or first[0].message.startswith("busy: "), first[0].message)
        self.assertTrue(refusals or not first[0].success)
        self.assertTrue(all(message.startswith("busy: ") for message in refusals), refusals)
        self.decompose_well()


if __name__ == "__main__":
    rospy.init_node("service_test")
    rostest.rosrun("collision_hulls", "service_test", ServiceTest)
