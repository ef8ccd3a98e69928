// A plate from -2 to 2 and -1 to 1 with two round holes of the radius 0.5 around (-1, 0) and (1, 0).
around = 3;
through = 2;
Point(1) = {-2, -1, 0};
Point(2) = {0, -1, 0};
Point(3) = {2, -1, 0};
Point(4) = {-2, 1, 0};
Point(5) = {0, 1, 0};
Point(6) = {2, 1, 0};
r = 0.5/Sqrt(2);
For hole In {0:1}
  x = 2*hole - 1;
  Point(10 + 10*hole) = {x, 0, 0};
  Point(11 + 10*hole) = {x - r, -r, 0};
  Point(12 + 10*hole) = {x + r, -r, 0};
  Point(13 + 10*hole) = {x + r, r, 0};
  Point(14 + 10*hole) = {x - r, r, 0};
  For i In {1:4}
    Circle(10 + 10*hole + i) = {10 + 10*hole + i, 10 + 10*hole, 11 + 10*hole + i%4};
  EndFor
EndFor
Line(1) = {1, 2};
Line(2) = {2, 5};
Line(3) = {5, 4};
Line(4) = {4, 1};
Line(5) = {2, 3};
Line(6) = {3, 6};
Line(7) = {6, 5};
// Spokes of the left hole, then of the right one.
Line(31) = {1, 11};
Line(32) = {2, 12};
Line(33) = {5, 13};
Line(34) = {4, 14};
Line(41) = {2, 21};
Line(42) = {3, 22};
Line(43) = {6, 23};
Line(44) = {5, 24};
Curve Loop(1) = {1, 32, -11, -31};
Curve Loop(2) = {2, 33, -12, -32};
Curve Loop(3) = {3, 34, -13, -33};
Curve Loop(4) = {4, 31, -14, -34};
Curve Loop(5) = {5, 42, -21, -41};
Curve Loop(6) = {6, 43, -22, -42};
Curve Loop(7) = {7, 44, -23, -43};
Curve Loop(8) = {-2, 41, -24, -44};
For i In {1:8}
  Plane Surface(i) = {i};
  Transfinite Surface {i};
  Recombine Surface {i};
EndFor
Transfinite Curve {1:7, 11:14, 21:24} = around + 1;
Transfinite Curve {31:34, 41:44} = through + 1;
Physical Surface("plate") = {1:8};
Physical Curve("left hole") = {11:14};
Physical Curve("right hole") = {21:24};
Physical Curve("bottom") = {1, 5};
Physical Curve("sides") = {3, 4, 6, 7};
