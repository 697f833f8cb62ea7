// Motor housing: a cup, open at z = 0, with ribs inside and cooling fins outside.
include <shapes.scad>

$fn = 36;

depth = 46;
wall = 4;
radius = 31;

difference() {
  union() {
    plate_xy(0, 6) circle(40);
    cylinder(h = depth, r = radius);
    translate([0, 0, depth - 0.5]) cylinder(h = 3.5, r1 = radius, r2 = radius - 4);
    for (z = [12:7:40]) plate_xy(z, z + 3) circle(36);
  }
  plate_xy(-nudge, depth - wall) difference() {
    circle(radius - wall);
    for (i = [0:3]) rotate(45 + 90 * i) translate([18, -2]) square([20, 4]);
  }
  plate_xy(-nudge, 6 + nudge) bolts(4, 36, 2, 45);
}
