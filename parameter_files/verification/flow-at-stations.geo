// Tube A of the thesis in cells of gmsh, for flow-of-own-mesh.prm: x is the axis, y the radius, in millimetres. The blocks meet on slanted
// lines, so that sections of the tube cut cells. The cells of the middle block are 1.4 times as long as their neighbours, 24 in a wavelength.

length = 446; radius = 12.5; wall = 0.1; slant = 3;
n_fluid = 6; n_wall = 1;             // cells across
n[] = {80, 30, 80};                  // along the axis, of each block
growth[] = {1.02, 1, 1/1.02};        // from cell to cell: small ones at the clamped ends
x[] = {0, 150, 305, length};         // where the blocks meet
s[] = {0, slant, -slant, 0};         // by how much the line there leans

For i In {0 : 3}
  Point(1 + i) = {x[i] - s[i], 0, 0};
  Point(11 + i) = {x[i] + s[i], radius, 0};
  Point(21 + i) = {x[i] + s[i], radius + wall, 0};
EndFor
For i In {1 : 3}
  Line(i) = {i, i + 1};
  Line(10 + i) = {10 + i, 11 + i};
  Line(20 + i) = {20 + i, 21 + i};
EndFor
For i In {1 : 4}
  Line(30 + i) = {i, 10 + i};
  Line(40 + i) = {10 + i, 20 + i};
EndFor
For i In {1 : 3}
  Curve Loop(i) = {i, 31 + i, -(10 + i), -(30 + i)};
  Plane Surface(i) = {i};
  Curve Loop(10 + i) = {10 + i, 41 + i, -(20 + i), -(40 + i)};
  Plane Surface(10 + i) = {10 + i};
  Transfinite Curve{i, 10 + i, 20 + i} = n[i - 1] + 1 Using Progression growth[i - 1];
EndFor
Transfinite Curve{31 : 34} = n_fluid + 1 Using Progression 0.45;
Transfinite Curve{41 : 44} = n_wall + 1;
Transfinite Surface{1 : 3, 11 : 13};
Recombine Surface{1 : 3, 11 : 13};

Physical Surface("fluid") = {1 : 3};
Physical Surface("wall") = {11 : 13};
Physical Curve("inlet") = {31};
Physical Curve("outlet") = {34};
Physical Curve("wall inlet end") = {41};
Physical Curve("wall outlet end") = {44};
Physical Curve("outside") = {21 : 23};
Physical Curve("axis") = {1 : 3};
