#ifndef continua_tests_studies_pulled_bar_h
#define continua_tests_studies_pulled_bar_h

/// A bar that is pulled in plane strain: (1 - nu^2)/Y times the traction is its strain, which
/// linear and quadratic velocities have exactly on any mesh.
constexpr const char *pulled_bar = R"(set Model    = plane strain
subsection Geometry
  set Type = box
  set Size = 2 m, 1 m
end
subsection Mesh
  set Cells = 1, 1
end
subsection Materials
  subsection body
    set Type            = hookean
    set Density         = 1000 kg/m^3
    set Young's modulus = 1 MPa
    set Poisson's ratio = 0.25
  end
end
subsection Boundaries
  subsection left
    set Type = roller
  end
  subsection right
    set Type     = traction
    set Traction = 1 kPa, 0 Pa
  end
  subsection bottom
    set Type = roller
  end
  subsection top
    set Type = free
  end
end
subsection Probes
  subsection end
    set Point  = 2 m, 0.5 m
    set Fields = displacement x
  end
end
)";

#endif
