// Two bodies that do not touch each other: a channel and a beam above it.
Point(1) = {0, 0, 0};      Point(2) = {0.1, 0, 0};    Point(3) = {0.1, 0.02, 0}; Point(4) = {0, 0.02, 0};
Point(5) = {0, 0.03, 0};   Point(6) = {0.1, 0.03, 0}; Point(7) = {0.1, 0.04, 0}; Point(8) = {0, 0.04, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Transfinite Curve {1, 3, 5, 7} = 7; Transfinite Curve {2, 4} = 4; Transfinite Curve {6, 8} = 2;
Transfinite Surface {1, 2}; Recombine Surface {1, 2};
Physical Surface("liquid") = {1}; Physical Surface("beam") = {2};
Physical Curve("inlet") = {4}; Physical Curve("outlet") = {2}; Physical Curve("channel walls") = {1, 3};
Physical Curve("clamped end") = {8}; Physical Curve("rest of the beam") = {5, 6, 7};
