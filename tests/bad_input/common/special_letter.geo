// A square whose group has a name with a letter that begins a comment in a parameter file.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 1};
Transfinite Curve{:} = 2;
Transfinite Surface{:};
Mesh.RecombineAll = 1;
Physical Surface("layer #1") = {1};
Physical Curve("side #1") = {1, 2, 3, 4};
