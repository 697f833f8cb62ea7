// Left gripper finger, closing towards -y: a carriage with bores for the two rails, an arm and a hook with a V-groove.
include <shapes.scad>

$fn = 24;
inner = -11;
outer = 10;

module carriage() {
  difference() {
    plate_yz(-11, 14) translate([inner, -22]) square([outer - inner, 44]);
    plate_xz(inner - nudge, outer + nudge) for (z = [-13, 13]) translate([0, z]) circle(4.6);
  }
}

module arm_outline() {
  polygon([[10, inner], [20, inner], [32, 2], [68, 2], [74, inner], [82, inner], [86, inner + 4], [90, inner], [94, inner],
           [94, -2], [84, outer], [10, outer]]);
}

carriage();
difference() {
  plate_xy(-12, 12) arm_outline();
  // A slot through the arm saves weight.
  plate_xz(0, outer + nudge) translate([48, 0]) rounded(30, 10, 5);
}
