#include <continua/continuum/end_models.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

void EndModels::reinit(const std::vector<Outlet> &outlets)
{
  first_ports.clear();
  unsigned int n_ports = 0;
  for (const Outlet &outlet : outlets)
  {
    first_ports.push_back(n_ports);
    n_ports += outlet.conditions.size();
  }
}

void EndModels::initialise(const std::vector<Outlet> &outlets)
{
  models.clear();
  for (const Outlet &outlet : outlets)
    models.push_back(make_end_model(outlet));
}

bool EndModels::linearise(const Step &step, const double *const flow_rates_old)
{
  bool changed = false;
  for (unsigned int o = 0; o < models.size(); ++o)
    changed = models[o]->linearise(step, flow_rates_old + first_ports[o]) || changed;
  return changed;
}

bool EndModels::linearise_steady(const double time)
{
  bool changed = false;
  for (const std::unique_ptr<EndModel> &model : models)
    changed = model->linearise_steady(time) || changed;
  return changed;
}

void EndModels::linearise_about(const std::vector<double> &flow_rates)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->linearise_about(&flow_rates[first_ports[o]]);
}

bool EndModels::correct(const std::vector<double> &flow_rates)
{
  bool changed = false;
  for (unsigned int o = 0; o < models.size(); ++o)
    changed = models[o]->correct(&flow_rates[first_ports[o]]) || changed;
  return changed;
}

void EndModels::set_predicted(Vector<double> &pressures) const
{
  for (unsigned int o = 0; o < models.size(); ++o)
    for (unsigned int i = 0; i < models[o]->n_ports(); ++i)
      pressures[first_ports[o] + i] = models[o]->predicted_pressures()[i];
}

void EndModels::set_impedances(FullMatrix<double> &impedances) const
{
  impedances = 0.;
  for (unsigned int o = 0; o < models.size(); ++o)
    impedances.add(models[o]->impedance(), 1., first_ports[o], first_ports[o]);
}

void EndModels::set_pressures(const std::vector<double> &flow_rates,
                              std::vector<double> &pressures) const
{
  for (unsigned int o = 0; o < models.size(); ++o)
  {
    const FullMatrix<double> impedance = models[o]->impedance();
    const double *const flows = &flow_rates[first_ports[o]];
    for (unsigned int i = 0; i < models[o]->n_ports(); ++i)
    {
      double &pressure = pressures[first_ports[o] + i];
      pressure = models[o]->predicted_pressures()[i];
      for (unsigned int j = 0; j < models[o]->n_ports(); ++j)
        pressure += impedance(i, j) * flows[j];
    }
  }
}

void EndModels::advance(const Step &step, const std::vector<double> &flow_rates)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->advance(step, &flow_rates[first_ports[o]]);
}

void EndModels::start_from(const std::vector<double> &flow_rates)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->start_from(&flow_rates[first_ports[o]]);
}

void EndModels::set_steady(const std::vector<double> &flow_rates)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->set_steady(&flow_rates[first_ports[o]]);
}

double EndModels::energy() const
{
  double sum = 0.;
  for (const std::unique_ptr<EndModel> &model : models)
    sum += model->energy();
  return sum;
}

std::vector<double> EndModels::present_pressures(const double time,
                                                 const std::vector<double> &flow_rates) const
{
  std::vector<double> pressures;
  for (unsigned int o = 0; o < models.size(); ++o)
  {
    const std::vector<double> of_outlet =
        models[o]->present_pressures(time, &flow_rates[first_ports[o]]);
    pressures.insert(pressures.end(), of_outlet.begin(), of_outlet.end());
  }
  return pressures;
}

bool EndModels::jumps(const double begin, const double end) const
{
  return std::any_of(models.begin(), models.end(),
                     [begin, end](const std::unique_ptr<EndModel> &model)
                     { return model->jumps(begin, end); });
}

const Network *EndModels::network()
{
  for (const std::unique_ptr<EndModel> &model : models)
    if (const Network *const found = model->network())
      return found;
  return nullptr;
}

void EndModels::visit(StateVisitor &visitor)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->visit(visitor, o);
}
} // namespace Continua
