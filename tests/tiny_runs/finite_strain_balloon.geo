// The section of the shipped file in fewer cells.
around = 16;
through = 1;
Include "../../parameter_files/verification/finite-strain-sphere-section.geo";
