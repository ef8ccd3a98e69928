#include <continua/analysis/periodic_powers.h>

#include <continua/base/table_writer.h>

#include <cmath>
#include <string>

namespace Continua
{
template <int dim>
void PeriodicPowers<dim>::add(const HarmonicSolution &solution, const HarmonicLoad &load)
{
  powers.push_back(system.powers(solution, load));
  double size = 0.;
  for (const auto part : {&HarmonicLoad::forces, &HarmonicLoad::velocities, &HarmonicLoad::ports})
  {
    HarmonicLoad of_part;
    of_part.*part = load.*part;
    size += std::abs(system.power_of(of_part, solution, load));
  }
  sizes_of_powers.push_back(size);
}

template <int dim>
void PeriodicPowers<dim>::write()
{
  const Problem &problem = run.input.problem;
  std::vector<std::string> header = {"harmonic [1]", "frequency [Hz]", "given [W]"};
  for (const std::string &region : problem.regions)
    for (const char *kind : {"viscosity", "relaxation", "supports"})
      header.push_back(region + ": " + kind + " [W]");
  for (const unsigned int condition : system.ports())
    header.push_back("taken behind " + problem.conditions[condition].name + " [W]");
  header.emplace_back("residual [W]");
  std::vector<std::vector<double>> rows;
  double scale = 0., residual = 0.;
  for (std::size_t k = 0; k < powers.size(); ++k)
  {
    const HarmonicPowers &of_harmonic = powers[k];
    std::vector<double> row = {k + 1., (k + 1.) / run.input.periodic_state.period,
                               of_harmonic.given()};
    for (const HarmonicPower &region : of_harmonic.regions)
      row.insert(row.end(), {region.viscosity, region.relaxation, region.supports});
    row.insert(row.end(), of_harmonic.ports.begin(), of_harmonic.ports.end());
    row.push_back(of_harmonic.given() - of_harmonic.taken());
    // Without damping nothing is taken.
    scale += sizes_of_powers[k] + std::abs(of_harmonic.taken());
    residual += std::abs(row.back());
    rows.push_back(row);
  }
  run.summary.add(
      {"largest imbalance of mean powers", scale > 0. ? residual / scale : 0., "1", ""});
  if (!run.is_writer)
    return;
  TableWriter table(run.directory.file("mean-power.csv"), header);
  for (const std::vector<double> &row : rows)
    table.row(row);
  table.flush();
}

template class PeriodicPowers<2>;
template class PeriodicPowers<3>;
} // namespace Continua
