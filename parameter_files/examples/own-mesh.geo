// Half the axial section of an artery with an aneurysm, for own-mesh.prm: x is the axis, y the radius, in millimetres.
// The bulge of the inner surface is height/2 (1 + cos(2 pi (x - middle)/extent)); the wall there is a region of its own.
// Look at it with: gmsh own-mesh.geo

length = 500; radius = 5; wall = 0.5;      // of the artery
middle = 230; extent = 60; height = 3;     // of the aneurysm
cell = 2.5;                                // along the axis
n_fluid = 6; n_wall = 1;                   // cells across

start = middle - extent/2;
end = middle + extent/2;

// Three blocks along the axis, each of fluid and wall. Lines y = 0, inner and outer surface of the wall:
Point(1) = {0, 0, 0};      Point(2) = {start, 0, 0};      Point(3) = {end, 0, 0};      Point(4) = {length, 0, 0};
Point(11) = {0, radius, 0}; Point(12) = {start, radius, 0}; Point(13) = {end, radius, 0}; Point(14) = {length, radius, 0};
Point(21) = {0, radius + wall, 0}; Point(22) = {start, radius + wall, 0};
Point(23) = {end, radius + wall, 0}; Point(24) = {length, radius + wall, 0};

Line(1) = {1, 2};   Line(2) = {2, 3};   Line(3) = {3, 4};
Line(11) = {11, 12}; Line(13) = {13, 14};
Line(21) = {21, 22}; Line(23) = {23, 24};

// The bulge: a spline through points of the cosine.
inner[] = {12};
outer[] = {22};
For i In {1 : 23}
  x = start + i*extent/24;
  bulge = height/2*(1 + Cos(2*Pi*(x - middle)/extent));
  p = newp; Point(p) = {x, radius + bulge, 0};        inner[] += p;
  p = newp; Point(p) = {x, radius + wall + bulge, 0}; outer[] += p;
EndFor
inner[] += 13;
outer[] += 23;
Spline(12) = inner[];
Spline(22) = outer[];

// Across: fluid 31..34, wall 41..44 at the four stations.
Line(31) = {1, 11};  Line(32) = {2, 12};  Line(33) = {3, 13};  Line(34) = {4, 14};
Line(41) = {11, 21}; Line(42) = {12, 22}; Line(43) = {13, 23}; Line(44) = {14, 24};

For i In {1 : 3}
  Curve Loop(i) = {i, 31 + i, -(10 + i), -(30 + i)};
  Plane Surface(i) = {i};
  Curve Loop(10 + i) = {10 + i, 41 + i, -(20 + i), -(40 + i)};
  Plane Surface(10 + i) = {10 + i};
EndFor

// Quadrilaterals in rows: the fluid's cells are small at the wall.
Transfinite Curve{1, 11, 21} = Round(start/cell) + 1;
Transfinite Curve{2, 12, 22} = Round(extent/cell) + 1;
Transfinite Curve{3, 13, 23} = Round((length - end)/cell) + 1;
Transfinite Curve{31 : 34} = n_fluid + 1 Using Progression 0.6;
Transfinite Curve{41 : 44} = n_wall + 1;
Transfinite Surface{1 : 3, 11 : 13};
Recombine Surface{1 : 3, 11 : 13};

// What the parameter file calls them:
Physical Surface("fluid") = {1, 2, 3};
Physical Surface("wall") = {11, 13};
Physical Surface("aneurysm") = {12};
Physical Curve("inlet") = {31};
Physical Curve("outlet") = {34};
Physical Curve("wall ends") = {41, 44};
Physical Curve("outside") = {21, 22, 23};
Physical Curve("axis") = {1, 2, 3};
