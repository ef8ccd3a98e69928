// The beam of two_bodies.geo alone.
Point(5) = {0, 0.03, 0};   Point(6) = {0.1, 0.03, 0}; Point(7) = {0.1, 0.04, 0}; Point(8) = {0, 0.04, 0};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Transfinite Curve {5, 7} = 7; Transfinite Curve {6, 8} = 2;
Transfinite Surface {2}; Recombine Surface {2};
Physical Surface("beam") = {2};
Physical Curve("clamped end") = {8}; Physical Curve("rest of the beam") = {5, 6, 7};
