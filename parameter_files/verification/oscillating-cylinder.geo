// A ring of liquid around a cylinder of diameter 1 m, in metres: quadrilaterals, curved, that grow away from the cylinder.
DefineConstant[around = 8];    // pairs of cells along a quarter of the cylinder
DefineConstant[outwards = 20]; // pairs of cells from the cylinder to the outside
DefineConstant[radius = 20];   // of the outside [m]
r = 0.5;
Point(1) = {0, 0, 0};
Point(2) = {r, 0, 0};
Point(3) = {0, r, 0};
Point(4) = {-r, 0, 0};
Point(5) = {0, -r, 0};
Point(6) = {radius, 0, 0};
Point(7) = {0, radius, 0};
Point(8) = {-radius, 0, 0};
Point(9) = {0, -radius, 0};
For k In {0:3}
  next = 2 + (k + 1)%4;
  Circle(1 + k) = {2 + k, 1, next};
  Circle(5 + k) = {6 + k, 1, next + 4};
  Line(9 + k) = {2 + k, 6 + k};
EndFor
For k In {0:3}
  Curve Loop(1 + k) = {9 + k, 5 + k, -(9 + (k + 1)%4), -(1 + k)};
  Plane Surface(1 + k) = {1 + k};
EndFor
Transfinite Curve {1:8} = around + 1;
Transfinite Curve {9:12} = outwards + 1 Using Progression 1.25;
Transfinite Surface {1:4};
Recombine Surface {1:4};
Mesh.ElementOrder = 2;
Physical Curve("cylinder") = {1:4};
Physical Curve("outside") = {5:8};
Physical Surface("fluid") = {1:4};
