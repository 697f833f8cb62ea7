// Gripper housing: a box open to the front (x), with ribs on its back wall and windows above and below.
include <shapes.scad>

depth = 46;
back = 6;

difference() {
  plate_yz(0, depth) rounded(116, 60, 8);
  difference() {
    plate_yz(back, depth + nudge) rounded(104, 48, 4);
    plate_yz(back - nudge, 16) for (y = [-40, -20, 20, 40]) translate([y - 2, -30]) square([4, 60]);
  }
  plate_yz(-nudge, back + nudge) {
    circle(12);
    bolts(4, 25, 3.2, 45);
  }
  plate_xy(-40, 40) for (y = [-32, 32]) translate([30, y]) rounded(14, 34, 7);
}
