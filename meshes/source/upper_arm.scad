// Upper arm: a beam with pockets on both sides and cross ribs in them. The lift axis is y; the elbow axis is parallel to it at
// z = 320. With coarse = true: the same beam without bores and trusses, like a collision mesh drawn by hand.
coarse = false;  // set before shapes.scad, whose $fn it overrides
include <shapes.scad>

$fn = coarse ? 16 : 48;

length = 320;
half_width = 32;
web = 4;  // half the web's thickness
lower = 38;
upper = 34;

module outline() {
  hull() {
    circle(lower);
    translate([0, length]) circle(upper);
  }
}

module truss() {
  z = [40, 105, 165, 225, 285];
  x = 34;
  for (i = [0:3]) {
    side = i % 2 == 0 ? x : -x;
    hull() {
      translate([-side, z[i]]) circle(3, $fn = 8);
      translate([side, z[i + 1]]) circle(3, $fn = 8);
    }
  }
}

module pocket() {
  difference() {
    offset(-7) outline();
    circle(36);
    translate([0, length]) circle(32);
    if (coarse) translate([-50, 162]) square([100, 6]);
    else truss();
  }
}

module pin() {
  along_y() {
    translate([0, 0, -54]) cylinder(h = 110, r = 19);
    translate([0, 0, 56.5]) cylinder(h = 6, r1 = 27, r2 = 24);
  }
}

module bosses() {
  plate_xz(-36, 36) circle(32);
  plate_xz(-33, 33) translate([0, length]) circle(28);
}

difference() {
  union() {
    plate_xz(-half_width, half_width) outline();
    bosses();
    if (!coarse) pin();
  }
  plate_xz(web, half_width + nudge) pocket();
  plate_xz(-half_width - nudge, -web) pocket();
  if (!coarse) plate_xz(-40, 40) translate([0, length]) circle(15);
}
