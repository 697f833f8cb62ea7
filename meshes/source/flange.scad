// Tool flange after ISO 9409-1-50-4-M6: four screws on a circle of 50, a centring bore of 31.5 and a dowel hole. Its axis is x.
include <shapes.scad>

along_x() difference() {
  cylinder(h = 12, r = 31.5);
  plate_xy(3, 6) difference() {
    circle(40);
    circle(29);
  }
  plate_xy(6, 12 + nudge) circle(15.75);
  plate_xy(-nudge, 12 + nudge) {
    circle(9);
    bolts(4, 25, 3.2, 45);
  }
  plate_xy(6, 12 + nudge) bolts(1, 25, 3);
}
