// The channel of two_bodies.geo alone.
Point(1) = {0, 0, 0};      Point(2) = {0.1, 0, 0};    Point(3) = {0.1, 0.02, 0}; Point(4) = {0, 0.02, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 7; Transfinite Curve {2, 4} = 4;
Transfinite Surface {1}; Recombine Surface {1};
Physical Surface("liquid") = {1};
Physical Curve("inlet") = {4}; Physical Curve("outlet") = {2}; Physical Curve("channel walls") = {1, 3};
