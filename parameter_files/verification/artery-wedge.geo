// A wedge of 15 degrees of a ring with the radii 0.71, 0.97 and 1.1 mm, about the z axis, 0.1 mm long.
mm = 1e-3;
radius[] = {0.71*mm, 0.97*mm, 1.1*mm};
cells[] = {12, 6};  // across the layers
around = 4;         // cells around
angle = Pi/12;
Point(1) = {0, 0, 0};
For i In {0:2}
  Point(10 + i) = {radius[i], 0, 0};
  Point(20 + i) = {radius[i]*Cos(angle), radius[i]*Sin(angle), 0};
  Circle(30 + i) = {10 + i, 1, 20 + i};
  Transfinite Curve {30 + i} = around + 1;
EndFor
For i In {0:1}
  Line(40 + i) = {10 + i, 11 + i};
  Line(50 + i) = {20 + i, 21 + i};
  Transfinite Curve {40 + i, 50 + i} = cells[i] + 1;
  Curve Loop(60 + i) = {40 + i, 31 + i, -(50 + i), -(30 + i)};
  Plane Surface(60 + i) = {60 + i};
  Transfinite Surface {60 + i};
  Recombine Surface {60 + i};
  out[] = Extrude {0, 0, 0.1*mm} { Surface{60 + i}; Layers{1}; Recombine; };
  top[] += out[0];
  volume[] += out[1];
  first[] += out[2];
  outer[] += out[3];
  second[] += out[4];
  inner[] += out[5];
EndFor
Physical Volume("media") = {volume[0]};
Physical Volume("adventitia") = {volume[1]};
Physical Surface("begin") = {60, 61};
Physical Surface("end") = {top[]};
Physical Surface("side 0") = {first[]};
Physical Surface("side 15") = {second[]};
Physical Surface("inside") = {inner[0]};
Physical Surface("outside") = {outer[1]};
