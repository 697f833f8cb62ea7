// Wrist: a hub on the pitch axis y, with a nose whose face at x = 58 carries the tool flange on the roll axis x.
include <shapes.scad>

difference() {
  union() {
    along_y() cylinder(h = 46, r = 21, center = true);
    along_y() cylinder(h = 76, r = 10, center = true);
    for (side = [0, 1]) mirror([0, side, 0]) along_y() translate([0, 0, 36.5]) cylinder(h = 4, r1 = 16, r2 = 14);
    hull() {
      along_y() cylinder(h = 40, r = 16, center = true);
      along_x() translate([0, 0, 38]) cylinder(h = 4, r = 24);
    }
    along_x() translate([0, 0, 40]) cylinder(h = 18, r = 27);
  }
  along_x() translate([0, 0, 26]) cylinder(h = 40, r = 14);
  plate_yz(50, 58 + nudge) bolts(8, 21, 2);
}
