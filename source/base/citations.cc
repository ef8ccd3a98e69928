#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/version.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace Continua
{
namespace
{
std::string continua_entry()
{
  return "@misc{continua,\n"
         "  author       = {{The Continua authors}},\n"
         "  title        = {Continua: single-solution fluid-structure interaction},\n"
         "  howpublished = {Computer program, version " +
         version() + ", revision " + revision() + "}\n}\n";
}

/// Key and entry.
std::vector<std::pair<std::string, std::string>> table()
{
  return {{"continua", continua_entry()},
          {"giannopapa2004", R"(@phdthesis{giannopapa2004,
  author = {Giannopapa, Christina Grigoria},
  title  = {Fluid structure interaction in flexible vessels},
  school = {King's College London, University of London},
  year   = {2004}
}
)"},
          {"dealii94", R"(@article{dealii94,
  author  = {Arndt, Daniel and Bangerth, Wolfgang and Feder, Marco and Fehling, Marc and
             Gassm{\"o}ller, Rene and Heister, Timo and Heltai, Luca and Kronbichler, Martin and
             Maier, Matthias and Munch, Peter and Pelteret, Jean-Paul and Sticko, Simon and
             Turcksin, Bruno and Wells, David},
  title   = {The {deal.II} library, version 9.4},
  journal = {Journal of Numerical Mathematics},
  volume  = {30},
  number  = {3},
  pages   = {231--246},
  year    = {2022},
  doi     = {10.1515/jnma-2022-0054}
}
)"},
          {"mumps", R"(@article{mumps,
  author  = {Amestoy, Patrick R. and Duff, Iain S. and L'Excellent, Jean-Yves and Koster, Jacko},
  title   = {A fully asynchronous multifrontal solver using distributed dynamic scheduling},
  journal = {SIAM Journal on Matrix Analysis and Applications},
  volume  = {23},
  number  = {1},
  pages   = {15--41},
  year    = {2001},
  doi     = {10.1137/S0895479899358194}
}
)"},
          {"cholmod", R"(@article{cholmod,
  author  = {Chen, Yanqing and Davis, Timothy A. and Hager, William W. and
             Rajamanickam, Sivasankaran},
  title   = {Algorithm 887: {CHOLMOD}, supernodal sparse {Cholesky} factorization and
             update/downdate},
  journal = {ACM Transactions on Mathematical Software},
  volume  = {35},
  number  = {3},
  pages   = {22:1--22:14},
  year    = {2008},
  doi     = {10.1145/1391989.1391995}
}
)"},
          {"p4est", R"(@article{p4est,
  author  = {Burstedde, Carsten and Wilcox, Lucas C. and Ghattas, Omar},
  title   = {{p4est}: Scalable algorithms for parallel adaptive mesh refinement on forests of
             octrees},
  journal = {SIAM Journal on Scientific Computing},
  volume  = {33},
  number  = {3},
  pages   = {1103--1133},
  year    = {2011},
  doi     = {10.1137/100791634}
}
)"},
          {"metis", R"(@article{metis,
  author  = {Karypis, George and Kumar, Vipin},
  title   = {A fast and high quality multilevel scheme for partitioning irregular graphs},
  journal = {SIAM Journal on Scientific Computing},
  volume  = {20},
  number  = {1},
  pages   = {359--392},
  year    = {1998},
  doi     = {10.1137/S1064827595287997}
}
)"},
          {"trilinos", R"(@misc{trilinos,
  author       = {{The Trilinos Project Team}},
  title        = {The {Trilinos} Project Website},
  howpublished = {\url{https://trilinos.github.io}}
}
)"},
          {"slepc", R"(@article{slepc,
  author  = {Hernandez, V. and Roman, J. E. and Vidal, V.},
  title   = {{SLEPc}: A scalable and flexible toolkit for the solution of eigenvalue problems},
  journal = {ACM Transactions on Mathematical Software},
  volume  = {31},
  number  = {3},
  pages   = {351--362},
  year    = {2005},
  doi     = {10.1145/1089014.1089019}
}
)"},
          {"hoodtaylor1973", R"(@article{hoodtaylor1973,
  author  = {Taylor, C. and Hood, P.},
  title   = {A numerical solution of the {Navier-Stokes} equations using the finite element
             technique},
  journal = {Computers \& Fluids},
  volume  = {1},
  number  = {1},
  pages   = {73--100},
  year    = {1973},
  doi     = {10.1016/0045-7930(73)90027-3}
}
)"},
          {"jasakweller2000", R"(@article{jasakweller2000,
  author  = {Jasak, H. and Weller, H. G.},
  title   = {Application of the finite volume method and unstructured meshes to linear elasticity},
  journal = {International Journal for Numerical Methods in Engineering},
  volume  = {48},
  number  = {2},
  pages   = {267--287},
  year    = {2000}
}
)"},
          {"rhiechow1983", R"(@article{rhiechow1983,
  author  = {Rhie, C. M. and Chow, W. L.},
  title   = {Numerical study of the turbulent flow past an airfoil with trailing edge separation},
  journal = {AIAA Journal},
  volume  = {21},
  number  = {11},
  pages   = {1525--1532},
  year    = {1983},
  doi     = {10.2514/3.8284}
}
)"},
          {"issa1986", R"(@article{issa1986,
  author  = {Issa, R. I.},
  title   = {Solution of the implicitly discretised fluid flow equations by operator-splitting},
  journal = {Journal of Computational Physics},
  volume  = {62},
  number  = {1},
  pages   = {40--65},
  year    = {1986},
  doi     = {10.1016/0021-9991(86)90099-9}
}
)"},
          {"aaa", R"(@article{aaa,
  author  = {Nakatsukasa, Yuji and S{\`e}te, Olivier and Trefethen, Lloyd N.},
  title   = {The {AAA} algorithm for rational approximation},
  journal = {SIAM Journal on Scientific Computing},
  volume  = {40},
  number  = {3},
  pages   = {A1494--A1522},
  year    = {2018},
  doi     = {10.1137/16M1106122}
}
)"},
          {"rannacher1984", R"(@article{rannacher1984,
  author  = {Rannacher, Rolf},
  title   = {Finite element solution of diffusion problems with irregular data},
  journal = {Numerische Mathematik},
  volume  = {43},
  pages   = {309--327},
  year    = {1984}
}
)"},
          {"roache1994", R"(@article{roache1994,
  author  = {Roache, P. J.},
  title   = {Perspective: a method for uniform reporting of grid refinement studies},
  journal = {Journal of Fluids Engineering},
  volume  = {116},
  number  = {3},
  pages   = {405--413},
  year    = {1994},
  doi     = {10.1115/1.2910291}
}
)"},
          {"celik2008", R"(@article{celik2008,
  author  = {Celik, Ishmail B. and Ghia, Urmila and Roache, Patrick J. and Freitas, Christopher J.
             and Coleman, Hugh and Raad, Peter E.},
  title   = {Procedure for estimation and reporting of uncertainty due to discretization in {CFD}
             applications},
  journal = {Journal of Fluids Engineering},
  volume  = {130},
  number  = {7},
  pages   = {078001},
  year    = {2008},
  doi     = {10.1115/1.2960953}
}
)"},
          {"arb", R"(@article{arb,
  author  = {Johansson, Fredrik},
  title   = {Arb: efficient arbitrary-precision midpoint-radius interval arithmetic},
  journal = {IEEE Transactions on Computers},
  volume  = {66},
  number  = {8},
  pages   = {1281--1292},
  year    = {2017},
  doi     = {10.1109/TC.2017.2690633}
}
)"}};
}
} // namespace

Citations::Citations() : used{"continua", "giannopapa2004", "dealii94"} {}

void Citations::add(const std::string &key)
{
  for (const auto &entry : table())
    if (entry.first == key)
    {
      used.insert(key);
      return;
    }
  AssertThrow(false, dealii::ExcMessage("There is no citation '" + key + "'."));
}

std::string Citations::bibtex() const
{
  std::string text;
  for (const auto &entry : table())
    if (used.count(entry.first) > 0)
      text += (text.empty() ? "" : "\n") + entry.second;
  return text;
}

void Citations::write(const std::string &file) const
{
  write_file_atomically(file, bibtex());
}

std::vector<std::string> Citations::keys()
{
  std::vector<std::string> result;
  for (const auto &entry : table())
    result.push_back(entry.first);
  return result;
}
} // namespace Continua
