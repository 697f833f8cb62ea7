// Guide rail of the gripper: a rod along x with a groove for a circlip near each end.
include <shapes.scad>

$fn = 24;

difference() {
  along_x() cylinder(h = 108, r = 4, center = true);
  for (x = [-49, 46]) along_x() translate([0, 0, x]) difference() {
    cylinder(h = 3, r = 6);
    cylinder(h = 3, r = 3);
  }
}
