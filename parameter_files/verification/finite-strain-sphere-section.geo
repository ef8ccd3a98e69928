// A quarter of the axial section of a hollow sphere with the radii 1 and 1.2; the axis is x.
DefineConstant[around = 128];  // cells along the quarter
DefineConstant[through = 2];  // layers of cells
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1.2, 0, 0};
Point(4) = {0, 1.2, 0};
Point(5) = {0, 1, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = through + 1;
Transfinite Curve {2, 4} = around + 1;
Transfinite Surface {1};
Recombine Surface {1};
Physical Surface("body") = {1};
Physical Curve("axis") = {1};
Physical Curve("outside") = {2};
Physical Curve("plane x") = {3};
Physical Curve("inside") = {4};
