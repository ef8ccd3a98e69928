// A windkessel and a model of two ports by the formulas that a person writes down: pressure,
// compliance, stored power and energy over steps of each scheme, a steady flow, a jump.

#include <continua/base/input_error.h>
#include <continua/continuum/outlet_model.h>

#include "../unit_test.h"

#include <algorithm>
#include <cmath>

namespace test_of_outlet_model
{
namespace
{
using namespace Continua;
constexpr double proximal = 3., distal = 40., compliance = 0.02, behind = 1.5, h = 0.1;

Outlet make_windkessel()
{
  Outlet outlet;
  outlet.name = "artery";
  outlet.conditions = {0};
  outlet.impedance = Impedance::windkessel(proximal, distal, compliance);
  outlet.pressure_behind = Waveform(behind);
  // A pressure of 2.5 Pa over that behind it.
  outlet.initial_states = {compliance * 2.5};
  return outlet;
}

double flow(const double time)
{
  return 0.4 * std::sin(5. * time) + 0.1;
}

/// The volume x of the compliance, dx/dt = Q - x/(R C), by each scheme's formula.
void windkessel(const std::string &scheme)
{
  const Outlet outlet = make_windkessel();
  OutletModel model(outlet);
  const double rate = 1. / (distal * compliance);
  double x = compliance * 2.5, older = x, law = 0., energy = 0., lost = 0.;
  check::relative(scheme + ": energy at the start", model.energy(), 0.5 * compliance * 6.25, 1e-13);
  for (unsigned int i = 0; i < 5; ++i)
  {
    const double t = i * h;
    const bool backward = scheme == "backward differencing" && i > 0;
    const Step step = scheme == "crank nicolson" ? crank_nicolson_step(t, h)
                      : backward ? backward_differencing_step(t, h, h, Update::implicit)
                                 : euler_step(t, h, Update::implicit);
    const double old_flow = flow(t), balanced_flow = flow(step.balance_time);
    double at_level = 0., next = 0.;
    if (step.extrapolate)
    {
      next = (x * (1. - 0.5 * h * rate) + h * balanced_flow) / (1. + 0.5 * h * rate);
      at_level = 0.5 * (x + next);
    }
    else if (backward)
      at_level = next = (2. * x - 0.5 * older + h * balanced_flow) / (1.5 + h * rate);
    else
      at_level = next = (x + h * balanced_flow) / (1. + h * rate);
    older = x;
    x = next;
    const bool changed = model.linearise(step, &old_flow);
    check::is_true(scheme + (changed ? ": new" : ": kept") + " impedance",
                   changed == (i == 0 || (i == 1 && backward)));
    const double pressure =
        model.predicted_pressures()[0] + model.impedance()(0, 0) * balanced_flow;
    law = std::max(
        law, std::abs(pressure - (behind + proximal * balanced_flow + at_level / compliance)));
    model.advance(step, &balanced_flow);
    energy = std::max(energy, std::abs(model.energy() - 0.5 * x * x / compliance));
    // p Q = stored + lost in both resistances + given to what is behind.
    const double loss = proximal * balanced_flow * balanced_flow +
                        at_level * at_level / (compliance * compliance * distal) +
                        behind * balanced_flow;
    lost = std::max(lost, std::abs(pressure * balanced_flow - model.stored_power() - loss));
    const double present_flow = flow(t + h);
    law = std::max(law, std::abs(model.present_pressures(t + h, &present_flow)[0] -
                                 (behind + proximal * present_flow + x / compliance)));
  }
  check::absolute(scheme + ": pressure", law, 0., 1e-12);
  check::absolute(scheme + ": energy", energy, 0., 1e-12);
  check::absolute(scheme + ": power", lost, 0., 1e-11);
}

void steady()
{
  Outlet outlet = make_windkessel();
  outlet.initial_states.clear();
  OutletModel model(outlet);
  model.linearise_steady(0.);
  const double q = 0.3;
  check::relative("steady: pressure", model.predicted_pressures()[0] + model.impedance()(0, 0) * q,
                  behind + (proximal + distal) * q, 1e-13);
  model.set_steady(&q);
  check::relative("steady: energy", model.energy(), 0.5 * compliance * std::pow(distal * q, 2),
                  1e-13);
  Outlet closed = outlet;
  closed.impedance.terms[0].rate = 0.;
  check::throws<RunError>(
      "steady: a compliance alone", [&]() { OutletModel(closed).linearise_steady(0.); },
      "the outlet 'artery' has no pressure that belongs to a steady flow");
}

/// On the way to a steady state a charge that is given stays, and comes with its part of the loads;
/// without one it is that of the steady flow.
void steady_search()
{
  Outlet outlet = make_windkessel();
  Step step = euler_step(0., h, Update::implicit);
  step.finds_steady_state = true;
  step.load_factor = 0.4;
  const double q = 0.3;
  const auto pressure_of = [&](OutletModel &model)
  {
    model.linearise(step, &q);
    return model.predicted_pressures()[0] + model.impedance()(0, 0) * q;
  };
  OutletModel charged(outlet);
  check::relative("to rest: pressure of a given charge", pressure_of(charged),
                  0.4 * (behind + 2.5) + proximal * q, 1e-13);
  step.load_factor = 1.;
  pressure_of(charged);
  charged.advance(step, &q);
  check::relative("to rest: a given charge stays", charged.energy(), 0.5 * compliance * 6.25,
                  1e-13);
  charged.linearise_steady(0.);
  check::relative("steady: a given charge",
                  charged.predicted_pressures()[0] + charged.impedance()(0, 0) * q,
                  behind + 2.5 + proximal * q, 1e-13);
  charged.set_steady(&q);
  check::relative("steady: a given charge stays", charged.energy(), 0.5 * compliance * 6.25, 1e-13);
  outlet.initial_states.clear();
  OutletModel empty(outlet);
  check::relative("to rest: pressure of the steady flow", pressure_of(empty),
                  behind + (proximal + distal) * q, 1e-13);
}

/// An end that counts from the start holds its pressure on the way to a steady state, and answers
/// to changes of the flow rate from then on.
void from_the_start()
{
  Outlet outlet = make_windkessel();
  outlet.initial_states.clear();
  outlet.counts_from_start = true;
  OutletModel model(outlet);
  Step step = euler_step(0., h, Update::implicit);
  step.finds_steady_state = true;
  const double start = 0.7, q = 1.;
  model.linearise(step, &start);
  check::relative("from the start: pressure at rest", model.predicted_pressures()[0], behind,
                  1e-13);
  check::absolute("from the start: no impedance at rest", model.impedance()(0, 0), 0., 1e-15);
  model.advance(step, &start);
  model.start_from(&start);
  step.finds_steady_state = false;
  check::is_true("from the start: another impedance", model.linearise(step, &start));
  const double response = h / (1. + h / (distal * compliance)) / compliance;
  check::relative("from the start: pressure",
                  model.predicted_pressures()[0] + model.impedance()(0, 0) * q,
                  behind + (proximal + response) * 0.3, 1e-13);
  model.advance(step, &q);
  check::relative("from the start: pressure at the end", model.present_pressures(h, &q)[0],
                  behind + (proximal + response) * 0.3, 1e-13);
}

/// Each of two ports changes the other's pressure.
void two_ports()
{
  Outlet outlet;
  outlet.conditions = {0, 1};
  outlet.pressure_behind = Waveform(20.);
  Impedance::Term term;
  term.rate = 3.;
  for (auto *matrix : {&outlet.impedance.direct, &term.residue})
  {
    matrix->reinit(2, 2);
    (*matrix)(0, 0) = 5.;
    (*matrix)(1, 1) = 4.;
    (*matrix)(0, 1) = (*matrix)(1, 0) = 2.;
  }
  outlet.impedance.terms = {term};
  OutletModel model(outlet);
  const double old_flows[2] = {0., 0.}, flows[2] = {0.5, -0.25};
  model.linearise(euler_step(0., h, Update::implicit), old_flows);
  const auto z = model.impedance();
  double pressures[2];
  for (unsigned int i = 0; i < 2; ++i)
    pressures[i] = model.predicted_pressures()[i] + z(i, 0) * flows[0] + z(i, 1) * flows[1];
  const double x = flows[0] * (1. + h / (1. + 3. * h)), y = flows[1] * (1. + h / (1. + 3. * h));
  check::relative("two ports: first", pressures[0], 20. + 5. * x + 2. * y, 1e-13);
  check::relative("two ports: second", pressures[1], 2. * x + 4. * y, 1e-13);
}
} // namespace

UNIT_TEST(outlet_model)
{
  for (const std::string scheme : {"euler", "backward differencing", "crank nicolson"})
    windkessel(scheme);
  steady();
  steady_search();
  from_the_start();
  two_ports();
  check::is_true("no jump", !OutletModel(make_windkessel()).jumps(0., 1.));
}
} // namespace test_of_outlet_model
