// An octant of a hollow sphere with the radii 1 and 1.2, in three blocks that meet on the diagonal; its planes are x = 0, y = 0 and z = 0.
DefineConstant[around = 16];  // cells along each edge of the three blocks
DefineConstant[through = 1];  // layers of cells
radius[] = {1, 1.2};
e = Sqrt(1/2);
d = Sqrt(1/3);
Point(1) = {0, 0, 0};
For i In {0:1}
  r = radius[i];
  p = 10 + 10*i;
  // The corners, the middles of the edges, the diagonal.
  Point(p + 1) = {r, 0, 0};
  Point(p + 2) = {0, r, 0};
  Point(p + 3) = {0, 0, r};
  Point(p + 4) = {r*e, r*e, 0};
  Point(p + 5) = {0, r*e, r*e};
  Point(p + 6) = {r*e, 0, r*e};
  Point(p + 7) = {r*d, r*d, r*d};
  Circle(p + 1) = {p + 1, 1, p + 4};
  Circle(p + 2) = {p + 4, 1, p + 2};
  Circle(p + 3) = {p + 2, 1, p + 5};
  Circle(p + 4) = {p + 5, 1, p + 3};
  Circle(p + 5) = {p + 3, 1, p + 6};
  Circle(p + 6) = {p + 6, 1, p + 1};
  Circle(p + 7) = {p + 4, 1, p + 7};
  Circle(p + 8) = {p + 5, 1, p + 7};
  Circle(p + 9) = {p + 6, 1, p + 7};
  Curve Loop(p + 1) = {p + 1, p + 7, -(p + 9), p + 6};
  Curve Loop(p + 2) = {p + 2, p + 3, p + 8, -(p + 7)};
  Curve Loop(p + 3) = {p + 4, p + 5, p + 9, -(p + 8)};
  For j In {1:3}
    Surface(p + j) = {p + j} In Sphere {1};
  EndFor
  For j In {1:9}
    Transfinite Curve {p + j} = around + 1;
  EndFor
EndFor
// The edges along the radius, and the faces between them.
For j In {1:7}
  Line(30 + j) = {10 + j, 20 + j};
  Transfinite Curve {30 + j} = through + 1;
EndFor
start[] = {1, 4, 2, 5, 3, 6, 4, 5, 6};
end[] = {4, 2, 5, 3, 6, 1, 7, 7, 7};
For j In {1:9}
  Curve Loop(40 + j) = {10 + j, 30 + end[j - 1], -(20 + j), -(30 + start[j - 1])};
  Plane Surface(40 + j) = {40 + j};
EndFor
Surface Loop(1) = {11, 21, 41, 47, 49, 46};
Surface Loop(2) = {12, 22, 42, 43, 48, 47};
Surface Loop(3) = {13, 23, 44, 45, 49, 48};
For j In {1:3}
  Volume(j) = {j};
EndFor
Transfinite Surface {:};
Recombine Surface {:};
Transfinite Volume {:};
Physical Volume("body") = {1, 2, 3};
Physical Surface("inside") = {11, 12, 13};
Physical Surface("outside") = {21, 22, 23};
Physical Surface("plane z") = {41, 42};
Physical Surface("plane x") = {43, 44};
Physical Surface("plane y") = {45, 46};
