#include <continua/theory/impedance.h>

namespace Continua
{
dealii::FullMatrix<Impedance::Complex> Impedance::value(const Complex &s) const
{
  dealii::FullMatrix<Complex> z(n_ports(), n_ports());
  for (unsigned int i = 0; i < n_ports(); ++i)
    for (unsigned int j = 0; j < n_ports(); ++j)
    {
      z(i, j) = direct(i, j);
      for (const Term &term : terms)
        z(i, j) += term.residue(i, j) / (s + term.rate);
    }
  return z;
}

Impedance Impedance::resistance(const double resistance)
{
  Impedance impedance;
  impedance.direct.reinit(1, 1);
  impedance.direct(0, 0) = resistance;
  impedance.terms_store_energy = true;
  return impedance;
}

Impedance Impedance::windkessel(const double proximal_resistance,
                                const double distal_resistance,
                                const double compliance)
{
  Impedance impedance = resistance(proximal_resistance);
  Term term;
  term.rate = 1. / (distal_resistance * compliance);
  term.residue.reinit(1, 1);
  term.residue(0, 0) = 1. / compliance;
  impedance.terms.push_back(term);
  return impedance;
}
} // namespace Continua
