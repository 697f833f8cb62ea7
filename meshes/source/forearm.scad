// Forearm: a hollow tube that ends in a U-fork. The roll axis is x, the wrist axis is parallel to y at x = 215.
include <shapes.scad>

axis = 215;
inner = 24;  // half the gap
outer = 36;
floor_end = 168;
tube_end = 118;

module tube() {
  along_x() {
    cylinder(h = 12, r = 40);
    translate([0, 0, 10]) cylinder(h = 10, r1 = 38, r2 = 31);
    translate([0, 0, 10]) cylinder(h = tube_end - 10, r1 = 32, r2 = 29);
  }
}

module transition() {
  hull() {
    along_x() translate([0, 0, tube_end]) cylinder(h = 1, r = 29);
    plate_yz(142, 150) rounded(2 * outer, 60, 8);
  }
}

module fork() {
  difference() {
    plate_xz(-outer, outer) hull() {
      translate([146, -30]) square([4, 60]);
      translate([axis, 0]) circle(26);
    }
    plate_yz(floor_end, axis + 30) square([2 * inner, 80], center = true);
    plate_xz(-outer - nudge, outer + nudge) translate([axis, 0]) {
      circle(11);
      bolts(4, 19, 2, 45);
    }
  }
}

difference() {
  union() {
    tube();
    transition();
    fork();
  }
  along_x() translate([0, 0, -nudge]) cylinder(h = 152, r = 22);
  along_x() translate([0, 0, 140]) cylinder(h = 40, r = 12);
  // Where cables enter from above.
  plate_xy(0, 60) translate([72, 0]) rounded(70, 18, 9);
  plate_yz(-nudge, 12 + nudge) bolts(6, 35.5, 2.5, 30);
}
