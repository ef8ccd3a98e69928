#include <continua/continuum/outlet_model.h>

#include <continua/base/input_error.h>
#include <continua/signal/jump.h>

#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
const double origin[3] = {0., 0., 0.};

double relaxation_time(const Impedance::Term &term)
{
  return term.rate > 0. ? 1. / term.rate : std::numeric_limits<double>::infinity();
}
} // namespace

OutletModel::OutletModel(const Outlet &outlet)
    : outlet(outlet), start_flow_rates(n_ports()), predicted(n_ports())
{
  const Vector<double> zero(n_ports());
  responses.assign(outlet.impedance.terms.size(), Response{zero, zero, zero, zero});
  for (unsigned int k = 0; k < outlet.initial_states.size(); ++k)
  {
    responses[k].present[0] = outlet.initial_states[k];
    responses[k].older = responses[k].at_level = responses[k].present;
  }
}

bool OutletModel::take_coefficients(const std::vector<double> &taken)
{
  const bool changed = coefficients != taken;
  coefficients = taken;
  return changed;
}

bool OutletModel::linearise(const Step &step, const double *const flow_rates_old)
{
  predicted = 0.;
  // Only on the way to a steady state do the loads come in parts.
  predicted[0] = step.load_factor * outlet.pressure_behind(origin, step.balance_time);
  new_coefficients.clear();
  if (step.finds_steady_state && outlet.counts_from_start)
  {
    for (Response &response : responses)
      response.at_level = 0.;
    new_coefficients.assign(responses.size() + 1, 0.);
    return take_coefficients(new_coefficients);
  }
  for (unsigned int k = 0; k < responses.size(); ++k)
  {
    const Impedance::Term &term = outlet.impedance.terms[k];
    Response &response = responses[k];
    if (step.finds_steady_state && has_given_charge())
    {
      new_coefficients.push_back(0.);
      response.at_level[0] = step.load_factor * outlet.initial_states[k];
      predicted[0] += term.residue(0, 0) * response.at_level[0];
      continue;
    }
    if (step.finds_steady_state && term.rate > 0.)
    {
      // In a steady flow x_k = Q / rate.
      new_coefficients.push_back(1. / term.rate);
      response.at_level = 0.;
      continue;
    }
    const BranchCoefficients of_step = step.branch(relaxation_time(term));
    new_coefficients.push_back(of_step.velocity);
    for (unsigned int j = 0; j < n_ports(); ++j)
      response.at_level[j] = of_step.old * response.present[j] + of_step.older * response.older[j] +
                             of_step.velocity_old * change_of_flow(flow_rates_old, j);
    for (unsigned int i = 0; i < n_ports(); ++i)
      for (unsigned int j = 0; j < n_ports(); ++j)
        predicted[i] += term.residue(i, j) * response.at_level[j];
  }
  new_coefficients.push_back(1.);
  const bool changed = take_coefficients(new_coefficients);
  if (outlet.counts_from_start)
  {
    const FullMatrix<double> of_step = impedance();
    for (unsigned int i = 0; i < n_ports(); ++i)
      for (unsigned int j = 0; j < n_ports(); ++j)
        predicted[i] -= of_step(i, j) * start_flow_rates[j];
  }
  return changed;
}

bool OutletModel::linearise_steady(const double time)
{
  predicted = 0.;
  predicted[0] = outlet.pressure_behind(origin, time);
  new_coefficients.clear();
  for (unsigned int k = 0; k < responses.size(); ++k)
  {
    const Impedance::Term &term = outlet.impedance.terms[k];
    if (has_given_charge())
    {
      predicted[0] += term.residue(0, 0) * outlet.initial_states[k];
      new_coefficients.push_back(0.);
      continue;
    }
    if (term.rate == 0.)
      throw RunError("the outlet '" + outlet.name +
                     "' has no pressure that belongs to a steady flow");
    new_coefficients.push_back(1. / term.rate);
  }
  new_coefficients.push_back(1.);
  return take_coefficients(new_coefficients);
}

FullMatrix<double> OutletModel::impedance() const
{
  FullMatrix<double> sum = outlet.impedance.direct;
  if (!coefficients.empty())
    sum *= coefficients.back();
  for (unsigned int k = 0; k + 1 < coefficients.size(); ++k)
    sum.add(coefficients[k], outlet.impedance.terms[k].residue);
  return sum;
}

void OutletModel::start_from(const double *const flow_rates)
{
  for (unsigned int j = 0; j < n_ports() && outlet.counts_from_start; ++j)
    start_flow_rates[j] = flow_rates[j];
}

void OutletModel::advance(const Step &step, const double *const flow_rates)
{
  for (unsigned int k = 0; k < responses.size(); ++k)
  {
    Response &response = responses[k];
    const Impedance::Term &term = outlet.impedance.terms[k];
    for (unsigned int j = 0; j < n_ports(); ++j)
    {
      const double flow_rate = change_of_flow(flow_rates, j);
      response.at_level[j] += coefficients[k] * flow_rate;
      response.rate[j] = flow_rate - term.rate * response.at_level[j];
    }
    response.older.swap(response.present);
    if (step.extrapolate)
    {
      response.present.equ(2., response.at_level);
      response.present.add(-1., response.older);
    }
    else
      response.present = response.at_level;
    // The exponential update obeys the equation over the step as a whole.
    if (step.branch_is_exponential(relaxation_time(term)))
    {
      response.rate.equ(1. / step.size(), response.present);
      response.rate.add(-1. / step.size(), response.older);
    }
  }
}

void OutletModel::set_steady(const double *const flow_rates)
{
  for (unsigned int k = 0; k < responses.size(); ++k)
    for (unsigned int j = 0; j < n_ports(); ++j)
      responses[k].present[j] = responses[k].at_level[j] =
          has_given_charge() ? outlet.initial_states[k]
                             : flow_rates[j] / outlet.impedance.terms[k].rate;
}

double OutletModel::stored_power() const
{
  double sum = 0.;
  for (unsigned int k = 0; k < responses.size() && outlet.impedance.terms_store_energy; ++k)
    for (unsigned int i = 0; i < n_ports(); ++i)
      for (unsigned int j = 0; j < n_ports(); ++j)
        sum += responses[k].at_level[i] * outlet.impedance.terms[k].residue(i, j) *
               responses[k].rate[j];
  return sum;
}

double OutletModel::energy() const
{
  double sum = 0.;
  for (unsigned int k = 0; k < responses.size() && outlet.impedance.terms_store_energy; ++k)
    sum += 0.5 * outlet.impedance.terms[k].residue.matrix_norm_square(responses[k].present);
  return sum;
}

std::vector<double> OutletModel::present_pressures(const double time,
                                                   const double *const flow_rates) const
{
  std::vector<double> pressures(n_ports(), 0.);
  pressures[0] = outlet.pressure_behind(origin, time);
  for (unsigned int i = 0; i < n_ports(); ++i)
    for (unsigned int j = 0; j < n_ports(); ++j)
    {
      pressures[i] += outlet.impedance.direct(i, j) * change_of_flow(flow_rates, j);
      for (unsigned int k = 0; k < responses.size(); ++k)
        pressures[i] += outlet.impedance.terms[k].residue(i, j) * responses[k].present[j];
    }
  return pressures;
}

bool OutletModel::jumps(const double begin, const double end) const
{
  return outlet.pressure_behind.depends_on_time() &&
         jumps_within([&](const double time) { return outlet.pressure_behind(origin, time); },
                      begin, end);
}

void OutletModel::visit(StateVisitor &visitor, const unsigned int number)
{
  for (unsigned int k = 0; k < responses.size(); ++k)
    visitor.levels({"outlet", number, k}, responses[k].present.begin(), responses[k].older.begin(),
                   n_ports());
  for (unsigned int j = 0; j < n_ports() && outlet.counts_from_start; ++j)
    visitor.value({"start of outlet", number, j}, start_flow_rates[j]);
}
} // namespace Continua
