// Shapes shared by several parts. Lengths are in millimetres; each part is drawn in the frame of its link.
$fn = 48;
screw_fn = 12;  // number of sides of a screw hole
nudge = 1;      // how far a cut extends past the face that it opens

// Turns a shape that stands on the z axis onto another axis.
module along_x() { rotate([0, 90, 0]) children(); }
module along_y() { rotate([-90, 0, 0]) children(); }

// Extrudes a 2D drawing, whose axes become x and z, from y0 to y1.
module plate_xz(y0, y1) { translate([0, y1, 0]) rotate([90, 0, 0]) linear_extrude(y1 - y0) children(); }

// Extrudes a 2D drawing, whose axes become y and z, from x0 to x1.
module plate_yz(x0, x1) { multmatrix([[0, 0, 1, x0], [1, 0, 0, 0], [0, 1, 0, 0]]) linear_extrude(x1 - x0) children(); }

// Extrudes a 2D drawing from z0 to z1.
module plate_xy(z0, z1) { translate([0, 0, z0]) linear_extrude(z1 - z0) children(); }

// A rectangle with rounded corners, centred at the origin; a slot if the radius is half a side.
module rounded(width, height, radius) {
  hull() for (x = [-1, 1], y = [-1, 1]) translate([x * (width / 2 - radius), y * (height / 2 - radius)]) circle(radius);
}

// Copies of a 2D drawing on a pitch circle.
module pattern(count, pitch_radius, start = 0) {
  for (i = [0:count - 1]) rotate(start + i * 360 / count) translate([pitch_radius, 0]) children();
}

// The holes of a bolt circle, as a 2D drawing.
module bolts(count, pitch_radius, radius, start = 0) { pattern(count, pitch_radius, start) circle(radius, $fn = screw_fn); }
