// Elbow: an L-bracket with a gusset. One leg turns about the elbow axis y beside the upper arm; the other carries the
// forearm, whose roll axis is parallel to x at z = 55.
include <shapes.scad>

roll = 55;
half_height = 41;
near = 69;
far = 85;

module side_leg() {
  plate_xz(33, 49) difference() {
    hull() {
      circle(34);
      translate([near, roll - half_height]) square([far - near, 2 * half_height]);
    }
    translate([0, 0]) bolts(4, 28, 2.5, 45);
    translate([52, 48]) circle(12);
  }
}

module front_leg() {
  plate_yz(near, far) translate([0, roll]) difference() {
    hull() {
      translate([39, -half_height]) square([10, 2 * half_height]);
      for (z = [-1, 1]) translate([-26, z * (half_height - 14)]) circle(14);
    }
    circle(18);
    bolts(6, 32, 3, 30);
  }
}

module gusset() { plate_xy(80, 88) polygon([[34, 34], [near + 1, -14], [near + 1, 34]]); }

module pin() {
  along_y() {
    translate([0, 0, -34]) cylinder(h = 70, r = 14);
    translate([0, 0, -40]) cylinder(h = 6.5, r1 = 21, r2 = 24);
  }
}

side_leg();
front_leg();
gusset();
pin();
