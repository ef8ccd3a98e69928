// The converging channel of Mok with a thin flap across it, in metres: a grid of blocks. The upper side is the middle of the whole channel.
DefineConstant[fine = 1];     // 2: cells of half the size
DefineConstant[flap_cells = 2]; // across the flap
height = 0.5; flap_place = 0.5; flap_height = 0.25; flap_thickness = 0.005; throat = 0.2; throat_place = 1.36; length = 1.75;
slope = 0.4034; // of the straight part of the lower side, behind the flap; an arc leads from it into the throat
angle = Atan(slope); rise = height - throat;
radius = (slope*(throat_place - flap_place - flap_thickness) - rise)/(slope*Sin(angle) - 1 + Cos(angle));
arc_place = throat_place - radius*Sin(angle); arc_start = rise - radius*(1 - Cos(angle));
x[] = {0, flap_place, flap_place + flap_thickness, arc_place, throat_place, length};
bottom[] = {0, 0, 0, arc_start, rise, rise};
// Cells of a column or a row of blocks, and the ratio of two neighbours along x or y.
n_x[] = {14*fine, flap_cells, 20*fine, 6*fine, 8*fine};
n_y[] = {20*fine, 12*fine};
ratio_x[] = {0.78^(1/fine), 1, 1.2^(1/fine), 1, 1.05^(1/fine)};
ratio_y[] = {0.93^(1/fine), 1.15^(1/fine)};
For i In {0:5}
  Point(1 + i) = {x[i], bottom[i], 0};
  Point(11 + i) = {x[i], (bottom[i] + height)/2, 0};
  Point(21 + i) = {x[i], height, 0};
EndFor
Point(31) = {throat_place, rise - radius, 0};
// Along x: 100 + i + 10 j; along y: 200 + i + 10 j.
For j In {0:2}
  For i In {0:4}
    If (i == 3 && j == 0)
      Circle(103) = {4, 31, 5};
    Else
      Line(100 + i + 10*j) = {1 + i + 10*j, 2 + i + 10*j};
    EndIf
    Transfinite Curve {100 + i + 10*j} = n_x[i] + 1 Using Progression ratio_x[i];
  EndFor
EndFor
For j In {0:1}
  For i In {0:5}
    Line(200 + i + 10*j) = {1 + i + 10*j, 11 + i + 10*j};
    Transfinite Curve {200 + i + 10*j} = n_y[j] + 1 Using Progression ratio_y[j];
  EndFor
EndFor
fluid[] = {};
For j In {0:1}
  For i In {0:4}
    Curve Loop(1 + i + 10*j) = {100 + i + 10*j, 201 + i + 10*j, -(100 + i + 10*(j + 1)), -(200 + i + 10*j)};
    Plane Surface(1 + i + 10*j) = {1 + i + 10*j};
    Transfinite Surface {1 + i + 10*j};
    Recombine Surface {1 + i + 10*j};
    If (i != 1 || j != 0)
      fluid[] += {1 + i + 10*j};
    EndIf
  EndFor
EndFor
Physical Surface("fluid") = {fluid[]};
Physical Surface("flap") = {2};
Physical Curve("inlet") = {200, 210};
Physical Curve("outlet") = {205, 215};
Physical Curve("bottom") = {100, 102, 103, 104};
Physical Curve("top") = {120, 121, 122, 123, 124};
Physical Curve("flap root") = {101};
