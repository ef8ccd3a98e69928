x = 0;
For i In {1 : 1e12}
  x = x + 1;
EndFor
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {0, 1, 0};
Point(4) = {1, 1, 0}; Point(5) = {0, 2, 0}; Point(6) = {1, 2, 0};
Line(1) = {1, 2}; Line(2) = {3, 4}; Line(3) = {5, 6};
Line(4) = {1, 3}; Line(5) = {3, 5}; Line(6) = {2, 4}; Line(7) = {4, 6};
Curve Loop(1) = {1, 6, -2, -4}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 7, -3, -5}; Plane Surface(2) = {2};
Transfinite Curve{1 : 7} = 2;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
Physical Surface("lower") = {1}; Physical Surface("upper") = {2};
Physical Curve("bottom") = {1}; Physical Curve("around") = {3 : 7};
