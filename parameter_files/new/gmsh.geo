// Half the axial section of a vessel with a narrow place: x is the axis, y the radius, in millimetres.
// Look at it with: gmsh gmsh.geo

length = 200; radius = 5; wall = 1;
middle = 120; extent = 40; depth = 2;      // of the narrow place
cell = 4;                                  // along the axis
n_fluid = 8; n_wall = 1;                   // cells across

// The inner and outer surface: splines through points.
For i In {0 : 50}
  x = length*i/50;
  bulge = 0;
  If (Fabs(x - middle) < extent/2)
    bulge = depth/2*(1 + Cos(2*Pi*(x - middle)/extent));
  EndIf
  p = newp; Point(p) = {x, 0, 0};                     axis[] += p;
  p = newp; Point(p) = {x, radius - bulge, 0};        inner[] += p;
  p = newp; Point(p) = {x, radius + wall - bulge, 0}; outer[] += p;
EndFor
Line(1) = {axis[0], axis[50]};
Spline(2) = inner[];
Spline(3) = outer[];
Line(11) = {axis[0], inner[0]};   Line(12) = {axis[50], inner[50]};
Line(21) = {inner[0], outer[0]};  Line(22) = {inner[50], outer[50]};
Curve Loop(1) = {1, 12, -2, -11}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 22, -3, -21}; Plane Surface(2) = {2};

// Quadrilaterals in rows.
Transfinite Curve{1, 2, 3} = Round(length/cell) + 1;
Transfinite Curve{11, 12} = n_fluid + 1 Using Progression 0.55; // small cells at the wall
Transfinite Curve{21, 22} = n_wall + 1;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};

// The names of the parameter file:
Physical Surface("fluid") = {1};
Physical Surface("wall") = {2};
Physical Curve("inlet") = {11};
Physical Curve("outlet") = {12};
Physical Curve("wall ends") = {21, 22};
Physical Curve("outside") = {3};
Physical Curve("axis") = {1};
