// The channel of Wall and Ramm with a square and a thin beam behind it, in metres: a grid of blocks, symmetric about the beam.
DefineConstant[fine = 1];       // 2: cells of half the size; 0.6, 1.4: numbers of cells are rounded
DefineConstant[beam_cells = 2]; // across the beam
side = 0.01; length = 0.04; thickness = 0.0006;
x[] = {0, 0.045, 0.055, 0.095, 0.195};
y[] = {0, 0.055, 0.06 - thickness/2, 0.06 + thickness/2, 0.065, 0.12};
// Cells of a column or a row of blocks, and the ratio of two neighbours along x or y.
n_x[] = {Round(9*fine), Round(8*fine), Round(22*fine), Round(24*fine)};
n_y[] = {Round(9*fine), Round(5*fine), Round(beam_cells*fine), Round(5*fine), Round(9*fine)};
ratio_x[] = {0.75^(1/fine), 1, 0.95^(1/fine), 1.07^(1/fine)};
ratio_y[] = {0.72^(1/fine), 0.72^(1/fine), 1, 1/0.72^(1/fine), 1/0.72^(1/fine)};
For j In {0:5}
  For i In {0:4}
    Point(1 + i + 5*j) = {x[i], y[j], 0};
  EndFor
EndFor
// Along x: 100 + i + 10 j; along y: 200 + i + 10 j.
For j In {0:5}
  For i In {0:3}
    If (i != 1 || j <= 1 || j >= 4)
      Line(100 + i + 10*j) = {1 + i + 5*j, 2 + i + 5*j};
      Transfinite Curve {100 + i + 10*j} = n_x[i] + 1 Using Progression ratio_x[i];
    EndIf
  EndFor
EndFor
For j In {0:4}
  For i In {0:4}
    Line(200 + i + 10*j) = {1 + i + 5*j, 1 + i + 5*(j + 1)};
    Transfinite Curve {200 + i + 10*j} = n_y[j] + 1 Using Progression ratio_y[j];
  EndFor
EndFor
fluid[] = {};
For j In {0:4}
  For i In {0:3}
    If (i != 1 || j == 0 || j == 4)
      Curve Loop(1 + i + 10*j) = {100 + i + 10*j, 201 + i + 10*j, -(100 + i + 10*(j + 1)), -(200 + i + 10*j)};
      Plane Surface(1 + i + 10*j) = {1 + i + 10*j};
      Transfinite Surface {1 + i + 10*j};
      Recombine Surface {1 + i + 10*j};
      If (i != 2 || j != 2)
        fluid[] += {1 + i + 10*j};
      EndIf
    EndIf
  EndFor
EndFor
Physical Surface("fluid") = {fluid[]};
Physical Surface("beam") = {23};
Physical Curve("inlet") = {200, 210, 220, 230, 240};
Physical Curve("outlet") = {204, 214, 224, 234, 244};
Physical Curve("bottom") = {100, 101, 102, 103};
Physical Curve("top") = {150, 151, 152, 153};
Physical Curve("square") = {111, 141, 201 + 10, 201 + 20, 201 + 30, 202 + 10, 202 + 30};
Physical Curve("beam root") = {202 + 20};
