// The sphere of the shipped file in fewer cells.
around = 4;
through = 1;
Include "../../parameter_files/verification/finite-strain-sphere.geo";
