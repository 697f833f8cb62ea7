// Shoulder: a turntable that carries a U-fork. The pan axis is z, the lift axis is parallel to y at z = 110.
include <shapes.scad>

axis = 110;
inner = 38;  // half the gap
outer = 56;
floor_top = 18;

module cheek_outline() {
  hull() {
    translate([-44, floor_top - 2]) square([88, 4]);
    translate([0, axis]) circle(40);
  }
}

module cheek() {
  difference() {
    plate_xz(inner, outer) cheek_outline();
    plate_xz(inner - nudge, outer + nudge) translate([0, axis]) {
      circle(20);
      bolts(6, 30, 3);
    }
    // A weight-saving pocket in the outer face.
    plate_xz(outer - 8, outer + nudge) translate([0, 46]) rounded(56, 36, 8);
  }
}

difference() {
  plate_xy(0, floor_top) circle(72);
  plate_xy(-nudge, floor_top + nudge) {
    circle(24);
    bolts(4, 62, 3.5);
  }
}
cheek();
mirror([0, 1, 0]) cheek();
