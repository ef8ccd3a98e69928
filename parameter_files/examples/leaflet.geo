// A channel of 20 mm with a leaflet that stands on its floor, 10 mm high and 1 mm thick; lengths in m.
height = 0.02; leaflet = 0.01; thickness = 0.001; upstream = 0.03; downstream = 0.06;
x[] = {0, upstream, upstream + thickness, upstream + thickness + downstream};
y[] = {0, leaflet, height};
across[] = {10, 10};    // cells below and above the tip
along[] = {12, 2, 27};  // cells before, in and behind the leaflet
For j In {0:2}
  For i In {0:3}
    Point(10*j + i + 1) = {x[i], y[j], 0};
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(100 + 10*j + i) = {10*j + i + 1, 10*j + i + 2};
  EndFor
  Transfinite Curve {100 + 10*j} = along[0] + 1 Using Progression 1/1.12;
  Transfinite Curve {101 + 10*j} = along[1] + 1;
  Transfinite Curve {102 + 10*j} = along[2] + 1 Using Progression 1.03;
EndFor
For i In {0:3}
  For j In {0:1}
    Line(200 + 10*i + j) = {10*j + i + 1, 10*(j + 1) + i + 1};
    Transfinite Curve {200 + 10*i + j} = across[j] + 1;
  EndFor
EndFor
For j In {0:1}
  For i In {0:2}
    Curve Loop(300 + 10*j + i) = {100 + 10*j + i, 200 + 10*(i + 1) + j, -(110 + 10*j + i), -(200 + 10*i + j)};
    Plane Surface(300 + 10*j + i) = {300 + 10*j + i};
  EndFor
EndFor
Transfinite Surface {:};
Recombine Surface {:};
Physical Surface("fluid") = {300, 302, 310, 311, 312};
Physical Surface("leaflet") = {301};
Physical Curve("inlet") = {200, 201};
Physical Curve("outlet") = {230, 231};
Physical Curve("floor") = {100, 102};
Physical Curve("root") = {101};
Physical Curve("roof") = {120, 121, 122};
