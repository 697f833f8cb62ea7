#!/usr/bin/python3
"""What rviz draws of the demo robot: the original, its links in colours of their own, and a model fitted to a scene."""
import argparse
import collections
import colorsys
import importlib.machinery
import importlib.util
import os
import shutil
import subprocess
import tempfile
import unittest

import rospkg
import rostest

PROGRAMS = ("Xvfb", "rviz", "import", "convert")
LEAST_PIXELS = 300  # of a hue, to count as a link that is seen


SCRIPT = os.path.join(rospkg.RosPack().get_path("collision_hulls"), "scripts", "rviz_picture")


class MissingLinksTest(unittest.TestCase):
    """A red cube before the camera, and pictures of it and of other things."""

    def missing(self, colour):
        loader = importlib.machinery.SourceFileLoader("rviz_picture", SCRIPT)
        script = importlib.util.module_from_spec(importlib.util.spec_from_loader("rviz_picture", loader))
        loader.exec_module(script)
        cube = script.Marker(ns="primitives/arm", type=script.Marker.CUBE)
        cube.pose.orientation.w = cube.scale.x = cube.scale.y = cube.scale.z = cube.color.r = 1
        view = argparse.Namespace(width=100, height=100, distance=3, yaw=0.4, pitch=0.3)
        camera = script.Camera(view, {"centre": [0, 0, 0], "radius": 1})
        with tempfile.NamedTemporaryFile(suffix=".ppm") as picture:
            subprocess.run(["convert", "-size", f"{camera.width}x{camera.height}", "xc:" + colour, picture.name], check=True)
            return script.missing_links(picture.name, [cube], lambda frame: script.numpy.eye(4), camera)

    def test_red_is_the_cube(self):
        self.assertEqual([], self.missing("rgb(200,20,20)"))

    def test_the_background_is_not(self):
        self.assertEqual(["arm"], self.missing("rgb(244,244,244)"))

    def test_another_link_is_not(self):
        self.assertEqual(["arm"], self.missing("rgb(20,20,200)"))

    def test_an_empty_window_is_not(self):
        self.assertEqual(["arm"], self.missing("white"))


class PictureTest(unittest.TestCase):
    def setUp(self):
        missing = [program for program in PROGRAMS if shutil.which(program) is None]
        if missing:
            self.skipTest("no picture without " + ", ".join(missing))
        self.folder = tempfile.mkdtemp(prefix="collision_hulls_test_")
        self.addCleanup(shutil.rmtree, self.folder)

    def crashing_rviz(self):
        """A folder with an rviz that crashes when it is started for the first time, as the real one sometimes does."""
        folder = os.path.join(self.folder, "bin")
        os.mkdir(folder)
        script, mark = os.path.join(folder, "rviz"), os.path.join(folder, "crashed")
        with open(script, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\n[ -e "{mark}" ] || {{ : > "{mark}"; kill -KILL $$; }}\nexec "{shutil.which("rviz")}" "$@"\n')
        os.chmod(script, 0o755)
        return folder

    def take_picture(self, *arguments, programs=""):
        # As in a shell that has sourced setup.bash: tests have the source folder on the path instead.
        environment = dict(os.environ, ROS_PACKAGE_PATH=os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0] + "/share",
                           PATH=programs + os.pathsep + os.environ["PATH"] if programs else os.environ["PATH"])
        return subprocess.run([SCRIPT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=330, check=False,
                              universal_newlines=True, env=environment)

    def hues(self, picture):
        """How many pixels are of each of twelve hues; pale and dark ones left out."""
        pixels = subprocess.run(["convert", picture, "-depth", "8", "rgb:-"], stdout=subprocess.PIPE, check=True).stdout
        colours = collections.Counter(zip(pixels[0::3], pixels[1::3], pixels[2::3]))
        counts = collections.Counter()
        for (red, green, blue), count in colours.items():
            hue, saturation, value = colorsys.rgb_to_hsv(red / 255, green / 255, blue / 255)
            if saturation > 0.5 and value > 0.3:
                counts[int(12 * hue)] += count
        return counts

    def test_three_panels(self):
        """The script itself checks that every link is seen; here, that what it saved has colours, and where."""
        picture = os.path.join(self.folder, "rviz.png")
        run = self.take_picture("-t", "5%", "-o", picture, programs=self.crashing_rviz())
        self.assertEqual(0, run.returncode, run.stdout)
        self.assertIn("rviz_picture: rviz ended, and there was no picture", run.stdout)
        self.assertIn("starting it again", run.stdout)
        hues = []
        for panel in range(3):
            part = os.path.join(self.folder, f"{panel}.ppm")
            subprocess.run(["convert", picture, "-crop", f"440x516+{440 * panel}+0", "+repage", part], check=True)
            hues.append([hue for hue, count in self.hues(part).items() if count >= LEAST_PIXELS])
        self.assertEqual([], hues[0])
        self.assertGreaterEqual(len(hues[1]), 4, hues)
        self.assertGreaterEqual(len(hues[2]), 4, hues)

    def test_nothing_is_saved_in_too_short_a_time(self):
        picture = os.path.join(self.folder, "rviz.png")
        run = self.take_picture("-t", "5%", "-o", picture, "--wait", "0")
        self.assertEqual(2, run.returncode, run.stdout)
        self.assertIn("--wait", run.stdout)
        self.assertFalse(os.path.exists(picture))

    def test_missing_file_is_named(self):
        run = self.take_picture("/nowhere.urdf", "-o", os.path.join(self.folder, "none.png"))
        self.assertEqual(2, run.returncode, run.stdout)
        self.assertIn("/nowhere.urdf", run.stdout)
        self.assertEqual([], os.listdir(self.folder))


if __name__ == "__main__":
    rostest.rosrun("collision_hulls", "picture_test", "picture_test")  # all of this module
