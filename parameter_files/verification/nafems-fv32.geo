// A membrane that becomes narrower, from 5 m to 1 m over 10 m; in metres.
Point(1) = {0, -2.5, 0};
Point(2) = {10, -0.5, 0};
Point(3) = {10, 0.5, 0};
Point(4) = {0, 2.5, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 17;
Transfinite Curve{2, 4} = 9;
Transfinite Surface{1};
Recombine Surface{1};
Physical Surface("membrane") = {1};
Physical Curve("clamped edge") = {4};
Physical Curve("free edges") = {1, 2, 3};
