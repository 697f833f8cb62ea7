// Base: a hollow pedestal on a foot plate, open below, with a cable channel to the back. The pan axis leaves the top at z = 90.
include <shapes.scad>

height = 90;
foot = 14;

module body() {
  plate_xy(0, foot) rounded(190, 190, 30);
  cylinder(h = 72, r1 = 78, r2 = 70);
  translate([0, 0, 68]) cylinder(h = height - 68, r = 74);
  for (angle = [45:90:315]) rotate(angle) plate_xz(-5, 5) polygon([[60, foot - 2], [96, foot - 2], [70, 56], [60, 56]]);
}

module cavity() {
  translate([0, 0, -nudge]) cylinder(h = 70 + nudge, r = 58);
  plate_xy(60, height + nudge) circle(24);
}

module cable_channel() { plate_yz(-100, -40) translate([-16, -nudge]) square([32, 28 + nudge]); }

difference() {
  body();
  cavity();
  cable_channel();
  plate_xy(-nudge, foot + nudge) for (x = [-78, 78], y = [-78, 78]) translate([x, y]) circle(5, $fn = 16);
}
