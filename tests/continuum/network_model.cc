// The network at ends of a body by itself: the impedance of a tube that goes on, a short vessel
// before a windkessel against that windkessel, the same of elements, steps of another size, the
// common pressure and flow rate with a body that is a resistance, volume, a state that is given
// back, parts of a section, and the way to a steady state.

#include <continua/base/input_error.h>
#include <continua/continuum/network_model.h>
#include <continua/continuum/outlet_model.h>
#include <continua/network/network_parameters.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_of_network_model
{
namespace
{
using namespace Continua;

constexpr double density = 1000., radius = 0.01, modulus = 4e5, thickness = 0.001, h = 1e-3;
const double area = M_PI * radius * radius,
             // Of a thin wall with Poisson's ratio 0.5 that is held along its axis.
    speed = std::sqrt(modulus * thickness / (1.5 * radius * density)),
             impedance = density * speed / area;

std::string vessel(const std::string &name,
                   const std::string &from,
                   const std::string &to,
                   const std::string &length)
{
  return "subsection " + name + "\nset From = " + from + "\nset To = " + to +
         "\nset Length = " + length +
         "\nset Radius at start = 10 mm\nset Wall thickness at start = 1 mm\n"
         "set Young's modulus = 400 kPa\nend\n";
}

Outlet outlet_of(const std::vector<std::string> &nodes,
                 const std::string &vessels,
                 const std::string &terminals,
                 const double fraction = 1.,
                 const std::string &elements = "")
{
  ParameterFile file =
      parameters_of("subsection Network\nset Density = 1000 kg/m^3\nset Viscosity = 0 Pa s\n"
                    "set Cell length = 2.5 mm\nsubsection Vessels\n" +
                    vessels + "end\nsubsection Elements\n" + elements +
                    "end\nsubsection Terminals\n" + terminals + "end\nend\n");
  const auto parameters = std::make_shared<NetworkParameters>();
  ParameterSection section = file.root().subsection("Network");
  parameters->nodes_at_body = nodes;
  parameters->read(section);
  parameters->read_materials(section, file.root().subsection("Materials"));
  parameters->check(section);
  Outlet outlet;
  outlet.name = "end";
  outlet.network = parameters;
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    outlet.conditions.push_back(i);
    outlet.fractions.push_back(fraction);
  }
  return outlet;
}

Step step_of(const std::string &scheme, const unsigned int i, const double size)
{
  if (scheme == "crank nicolson")
    return crank_nicolson_step(i * size, size);
  if (scheme == "backward differencing" && i > 0)
    return backward_differencing_step(i * size, size, size, Update::implicit);
  return euler_step(i * size, size, Update::implicit);
}

double pulse(const double time)
{
  const double end = 0.04;
  return time > 0. && time < end ? 1e-7 * std::pow(std::sin(M_PI * time / end), 2) : 0.;
}

/// The pressure with the flow rate at the balanced level.
double pressure_with(NetworkModel &model, const double flow_rate)
{
  while (model.correct(&flow_rate))
  {
  }
  return model.predicted_pressures()[0] + model.impedance()(0, 0) * flow_rate;
}

/// A wave leaves into a tube that goes on: the pressure is its impedance times the flow rate.
void tube_that_goes_on(const std::string &scheme, const double fraction)
{
  const Outlet outlet = outlet_of({"joint"}, vessel("tube", "joint", "end", "0.5 m"),
                                  "subsection end\nset Type = absorbing\nend\n", fraction);
  NetworkModel model(outlet);
  double largest = 0., volume = 0.;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const Step step = step_of(scheme, i, h);
    const double flow = fraction * pulse(step.balance_time);
    model.linearise(step, nullptr);
    const double pressure = pressure_with(model, flow);
    largest = std::max(largest, std::abs(pressure * fraction / impedance - flow));
    model.advance(step, &flow);
    // Implicit steps take the network half of their first step ahead.
    volume += (i == 0 && scheme != "crank nicolson" ? 1.5 : 1.) * flow * h / fraction;
  }
  const std::string name = scheme + (fraction == 1. ? "" : ", a quarter");
  check::absolute(name + ": flow rate over the impedance", largest / (fraction * 1e-7), 0., 0.005);
  check::relative(name + ": volume in the network", model.network()->inflow(), volume, 1e-12);
}

/// A body that is a pressure before a resistance, at a vessel of 1 mm before a windkessel: nearly
/// the windkessel alone.
void short_vessel()
{
  const double proximal = impedance, distal = 10. * impedance, compliance = 1e-8,
               body = 2. * impedance;
  const Outlet outlet =
      outlet_of({"joint"}, vessel("tube", "joint", "end", "1 mm"),
                "subsection end\nset Type = windkessel\nset Proximal resistance = " +
                    std::to_string(proximal) + " Pa s/m^3\nset Distal resistance = " +
                    std::to_string(distal) + " Pa s/m^3\nset Compliance = 1e-8 m^3/Pa\nend\n");
  Outlet alone;
  alone.name = "alone";
  alone.conditions = {0};
  alone.impedance = Impedance::windkessel(proximal, distal, compliance);
  NetworkModel model(outlet);
  OutletModel exact(alone);
  double largest = 0., difference = 0., defect = 0., flow = 0., flow_alone = 0.;
  unsigned int most = 0;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const Step step = crank_nicolson_step(i * h, h);
    const double load = 100. * std::pow(std::sin(M_PI * step.balance_time / 0.2), 2);
    model.linearise(step, &flow);
    exact.linearise(step, &flow_alone);
    unsigned int n = 0;
    do
    {
      flow = (load - model.predicted_pressures()[0]) / (body + model.impedance()(0, 0));
      ++n;
    } while (model.correct(&flow));
    flow_alone = (load - exact.predicted_pressures()[0]) / (body + exact.impedance()(0, 0));
    const double pressure = load - body * flow;
    // The relation through the network's own pressure, not the one that gave the flow rate.
    model.linearise_about(&flow);
    defect = std::max(defect, std::abs(model.predicted_pressures()[0] +
                                       model.impedance()(0, 0) * flow - pressure));
    most = std::max(most, n);
    largest = std::max(largest, std::abs(pressure));
    difference = std::max(difference, std::abs(pressure - (load - body * flow_alone)));
    model.advance(step, &flow);
    exact.advance(step, &flow_alone);
  }
  check::absolute("a short vessel: difference from the windkessel", difference / largest, 0.,
                  0.002);
  check::absolute("a short vessel: pressure on both sides", defect / largest, 0., 1e-9);
  check::is_true("a short vessel: at most five corrections", most <= 6);
}

/// A body that is a pressure before a resistance, at elements that are a windkessel: by the middle
/// of the step both are the same to round-off.
void windkessel_of_elements()
{
  const double proximal = 8e6, distal = 120e6, compliance = 1e-8, body = 4e6;
  const Outlet outlet = outlet_of(
      {"joint"}, "", "subsection open\nset Type = pressure\nset Pressure = 0\nend\n", 0.25,
      "subsection proximal\nset Type = resistance\nset From = joint\n"
      "set To = store\nset Resistance = 8 MPa s/m^3\nend\n"
      "subsection store\nset Type = compliance\nset Node = store\n"
      "set Compliance = 1e-8 m^3/Pa\nend\n"
      "subsection distal\nset Type = resistance\nset From = store\n"
      "set To = open\nset Resistance = 120 MPa s/m^3\nend\n");
  Outlet alone;
  alone.name = "alone";
  alone.conditions = {0};
  alone.impedance = Impedance::windkessel(4. * proximal, 4. * distal, 0.25 * compliance);
  NetworkModel model(outlet);
  OutletModel exact(alone);
  double largest = 0., difference = 0., flow = 0., flow_alone = 0.;
  for (unsigned int i = 0; i < 300; ++i)
  {
    const Step step = crank_nicolson_step(i * h, h);
    const double load = 100. * std::pow(std::sin(M_PI * step.balance_time / 0.2), 2);
    model.linearise(step, &flow);
    exact.linearise(step, &flow_alone);
    do
      flow = (load - model.predicted_pressures()[0]) / (4. * body + model.impedance()(0, 0));
    while (model.correct(&flow));
    flow_alone = (load - exact.predicted_pressures()[0]) / (4. * body + exact.impedance()(0, 0));
    largest = std::max(largest, std::abs(load - 4. * body * flow_alone));
    difference = std::max(difference, 4. * body * std::abs(flow - flow_alone));
    model.advance(step, &flow);
    exact.advance(step, &flow_alone);
  }
  check::absolute("a windkessel of elements: difference from the windkessel", difference / largest,
                  0., 1e-9);
}

/// A given flow rate into a tube that goes on, in steps of which some are a 32nd and an 8th of the
/// others: what has entered is what has flowed by the time of the network, half a step ahead, and
/// the pressure stays that of the impedance.
void steps_of_another_size(const std::string &scheme)
{
  const double end = 0.08, largest = 1e-7;
  const Outlet outlet = outlet_of({"joint"}, vessel("tube", "joint", "end", "0.5 m"),
                                  "subsection end\nset Type = absorbing\nend\n");
  NetworkModel model(outlet);
  double time = 0., last_size = h, error_of_volume = 0., error_of_pressure = 0.;
  while (time < end - 0.5 * last_size)
  {
    const double size = time < 0.0299 ? h : time < 0.0499 ? h / 32. : h / 8.;
    const Step step = time == 0. || scheme == "euler"
                          ? euler_step(time, size, Update::implicit)
                          : backward_differencing_step(time, size, last_size, Update::implicit);
    const double flow = largest * std::pow(std::sin(M_PI * step.balance_time / end), 2);
    model.linearise(step, nullptr);
    const double pressure = pressure_with(model, flow);
    model.advance(step, &flow);
    time += size;
    last_size = size;
    const double of_network = model.network()->time(), angle = 2. * M_PI * of_network / end,
                 exact = 0.5 * largest * (of_network - end / (2. * M_PI) * std::sin(angle));
    error_of_volume = std::max(error_of_volume, std::abs(model.network()->inflow() - exact));
    error_of_pressure = std::max(error_of_pressure, std::abs(pressure / impedance - flow));
  }
  const std::string name = scheme + ", steps of another size: ";
  check::absolute(name + "volume", error_of_volume / (0.5 * largest * end), 0., 1e-4);
  check::absolute(name + "pressure", error_of_pressure / largest, 0., 0.005);
}

/// A pressure over time at the other end of a tube of 0.1 m, before a body that is the impedance of
/// the tube: at the joint is the wave of d'Alembert, late by the time along the tube. Returns the
/// largest error at the balanced levels, over the height of the pulse.
double error_of_a_terminal_in_time(const std::string &scheme, const double size)
{
  const double length = 0.1, late = length / speed, end = 0.12;
  Outlet outlet = outlet_of({"joint"}, vessel("tube", "joint", "end", "0.1 m"),
                            "subsection end\nset Type = pressure\nset Pressure = 0\nend\n");
  const auto in_time = std::make_shared<NetworkParameters>(*outlet.network);
  in_time->cell_length = 0.5e-3;
  in_time->terminals.front().law.value = [end](const double time)
  { return time > 0. && time < end ? std::pow(std::sin(M_PI * time / end), 4) : 0.; };
  outlet.network = in_time;
  NetworkModel model(outlet);
  double largest = 0., flow = 0.;
  for (unsigned int i = 0; i * size < end + late; ++i)
  {
    const Step step = step_of(scheme, i, size);
    model.linearise(step, &flow);
    do
      flow = -model.predicted_pressures()[0] / (impedance + model.impedance()(0, 0));
    while (model.correct(&flow));
    largest = std::max(largest, std::abs(-impedance * flow - in_time->terminals.front().law.value(
                                                                 step.balance_time - late)));
    model.advance(step, &flow);
  }
  return largest;
}

/// What leaves the body for a tube with a closed end is what the tube stores.
void energy()
{
  const Outlet outlet = outlet_of({"joint"}, vessel("tube", "joint", "end", "0.5 m"),
                                  "subsection end\nset Type = closed\nend\n");
  NetworkModel model(outlet);
  double left = 0., stored = 0.;
  const double before = model.network()->energy();
  for (unsigned int i = 0; i < 60; ++i)
  {
    const Step step = crank_nicolson_step(i * h, h);
    const double flow = 100. * pulse(step.balance_time);
    model.linearise(step, nullptr);
    const double pressure = pressure_with(model, flow);
    model.advance(step, &flow);
    left += h * pressure * flow;
    stored += h * model.stored_power();
  }
  check::relative("energy: stored over time", stored, model.network()->energy() - before, 1e-6);
  check::relative("energy: what left the body is stored", stored, left, 3e-3);
}

void terminals_in_time()
{
  for (const std::string scheme : {"euler", "backward differencing", "crank nicolson"})
  {
    const double coarse = error_of_a_terminal_in_time(scheme, 8e-3),
                 fine = error_of_a_terminal_in_time(scheme, 4e-3);
    check::absolute(scheme + ": a terminal in time", fine, 0., 0.006);
    check::absolute(scheme + ": a terminal in time: order", std::log2(coarse / fine), 2., 0.25);
  }
}

class Numbers : public NumbersVisitor
{
public:
  std::vector<double> kept;
  bool gives = false;
  std::size_t next = 0;

private:
  void take_levels(double *const present, double *, const std::size_t n) override
  {
    take_values(present, n);
  }
  void take_values(double *const numbers, const std::size_t n) override
  {
    for (std::size_t i = 0; i < n; ++i)
      if (gives)
        numbers[i] = kept.at(next++);
      else
        kept.push_back(numbers[i]);
  }
};

/// Both ends of a tube: what flows in at one flows out at the other after the time of the wave. A
/// step that is undone leaves no trace.
void loop()
{
  const Outlet outlet =
      outlet_of({"first", "second"}, vessel("tube", "first", "second", "0.1 m"), "");
  NetworkModel model(outlet);
  double flows[2] = {0., 0.}, old[2] = {0., 0.};
  const auto make_step = [&](const unsigned int i, const double size)
  {
    const Step step = crank_nicolson_step(i * h, size);
    model.linearise(step, old);
    // At the second end stands the impedance of the tube, so that nothing comes back.
    for (unsigned int k = 0; k < 20; ++k)
    {
      flows[0] = pulse(step.balance_time);
      const auto z = model.impedance();
      flows[1] = -(model.predicted_pressures()[1] + z(1, 0) * flows[0]) / (impedance + z(1, 1));
      if (!model.correct(flows))
        break;
    }
    const auto z = model.impedance();
    const double pressure =
        model.predicted_pressures()[0] + z(0, 0) * flows[0] + z(0, 1) * flows[1];
    model.advance(step, flows);
    return pressure;
  };
  Numbers keep;
  double back = 0., largest_out = 0., first_time = 0.;
  for (unsigned int i = 0; i < 60; ++i)
  {
    if (i == 20)
    {
      model.visit(keep, 0);
      first_time = make_step(i, 0.5 * h);
      Numbers give;
      give.kept = keep.kept;
      give.gives = true;
      model.visit(give, 0);
      check::is_true("a step that is undone is made again to the last bit",
                     make_step(i, 0.5 * h) == first_time);
      give.next = 0;
      model.visit(give, 0);
    }
    const double pressure = make_step(i, h);
    back = std::max(back, std::abs(pressure - impedance * flows[0]));
    largest_out = std::max(largest_out, -flows[1]);
  }
  check::absolute("a loop: nothing comes back", back / (impedance * 1e-7), 0., 0.01);
  check::absolute("a loop: what flows in flows out", largest_out / 1e-7, 1., 0.02);
}

void steady_search_and_failures()
{
  Outlet outlet = outlet_of({"joint"}, vessel("tube", "joint", "end", "0.5 m"),
                            "subsection end\nset Type = closed\nend\n");
  const auto under_pressure = std::make_shared<NetworkParameters>(*outlet.network);
  under_pressure->initial_pressure = 1000.;
  outlet.network = under_pressure;
  NetworkModel model(outlet);
  Step step = static_step(h, false);
  step.load_factor = 0.4;
  const double flow = 1e-6, none = 0.;
  model.linearise(step, &flow);
  check::relative("to rest: the pressure comes with the loads", model.predicted_pressures()[0],
                  400., 1e-12);
  check::absolute("to rest: no impedance", model.impedance()(0, 0), 0., 1e-15);
  model.advance(step, &flow);
  check::absolute("to rest: nothing flows in", model.network()->inflow(), 0., 1e-30);
  step = crank_nicolson_step(0., h);
  model.linearise(step, &none);
  check::relative("at rest", pressure_with(model, 0.), 1000., 1e-13);
  check::throws<RunError>(
      "no steady flow", [&]() { model.linearise_steady(0.); },
      "the network at 'end' has no place in a steady analysis");
  const double strong = -2. * area * speed;
  check::throws<StepFailure>(
      "a tube that closes", [&]() { model.correct(&strong); }, "of the vessel 'tube'");
}
} // namespace

UNIT_TEST(network_model)
{
  for (const std::string scheme : {"euler", "backward differencing", "crank nicolson"})
    tube_that_goes_on(scheme, 1.);
  tube_that_goes_on("crank nicolson", 0.25);
  short_vessel();
  windkessel_of_elements();
  steps_of_another_size("euler");
  steps_of_another_size("backward differencing");
  terminals_in_time();
  energy();
  loop();
  steady_search_and_failures();
}
} // namespace test_of_network_model
