// Order, limit and estimated error of sequences on finer and finer meshes: with a known limit and
// order, and the published examples of two guides to the method.

#include <continua/postprocess/grid_convergence.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_grid_convergence
{
using namespace Continua;
using Behaviour = GridConvergence::Behaviour;

namespace
{
constexpr double round_off = 1e-14;

/// limit + c h^p at the cell sizes.
GridConvergence power(const std::vector<double> &sizes, const double c, const double p)
{
  std::vector<double> values;
  for (const double h : sizes)
    values.push_back(3. + c * std::pow(h, p));
  return GridConvergence(sizes, values, {2., 4.}, round_off);
}

void known_orders()
{
  for (const double p : {0.75, 1., 2., 4.})
    for (const std::vector<double> &sizes :
         {std::vector<double>{1., 0.5, 0.25}, {1., 0.75, 0.3}, {0.4, 0.2, 0.05}})
    {
      const GridConvergence result = power(sizes, 0.1, p);
      const double error = 0.1 * std::pow(sizes.back(), p);
      const std::string name = "order " + std::to_string(p).substr(0, 4) + ", cells down to " +
                               std::to_string(sizes.back()).substr(0, 5) + ": ";
      check::is_true(name + "monotone",
                     result.behaviour == Behaviour::monotone && result.order_plausible);
      check::absolute(name + "order", result.order, p, 1e-8);
      check::absolute(name + "limit", result.limit, 3., 1e-8 * error);
      check::relative(name + "error", result.estimated_error, 1.25 * error, 1e-7);
    }
  const GridConvergence four =
      GridConvergence({1., 0.5, 0.25, 0.125}, {17., 2., 1.25, 1.0625}, {2., 4.}, round_off);
  check::is_true("the three finest of four",
                 std::abs(four.order - 2.) < 1e-9 && std::abs(four.limit - 1.) < 1e-9);
}

void published()
{
  // J. W. Slater, "Examining spatial (grid) convergence", NPARC Alliance: pressure recovery of an
  // inlet on three meshes with ratio 2.
  const GridConvergence inlet({4., 2., 1.}, {0.96178, 0.96854, 0.97050}, {2., 2.}, round_off);
  check::absolute("NPARC: order", inlet.order, 1.786170, 1e-6);
  check::absolute("NPARC: limit", inlet.limit, 0.97130, 5e-6);
  check::absolute("NPARC: grid convergence index [%]", 100. * inlet.estimated_error / 0.97050,
                  0.103083, 1e-6);

  // I. B. Celik et al., J. Fluids Eng. 130, 078001, 2008, table 1: 18000, 8000 and 4500 cells in
  // two dimensions.
  const std::vector<double> sizes = {std::sqrt(1. / 4500.), std::sqrt(1. / 8000.),
                                     std::sqrt(1. / 18000.)};
  const GridConvergence length(sizes, {5.863, 5.972, 6.063}, {2., 2.}, round_off);
  check::absolute("reattachment length: order", length.order, 1.53, 0.005);
  check::absolute("reattachment length: limit", length.limit, 6.1685, 5e-4);
  check::absolute("reattachment length: index [%]", 100. * length.estimated_error / 6.063, 2.2,
                  0.05);
  // Its other two columns are of 18000, 4500 and 980 cells.
  const std::vector<double> wider = {std::sqrt(1. / 980.), std::sqrt(1. / 4500.),
                                     std::sqrt(1. / 18000.)};
  const GridConvergence velocity(wider, {10.6050, 10.7250, 10.7880}, {2., 2.}, round_off);
  check::absolute("axial velocity: order", velocity.order, 0.75, 0.005);
  check::absolute("axial velocity: limit", velocity.limit, 10.8801, 5e-4);
  check::absolute("axial velocity: index [%]", 100. * velocity.estimated_error / 10.7880, 1.1,
                  0.05);
  // Its third column oscillates; the paper takes an order of the magnitudes all the same, here it
  // is only said.
  const GridConvergence oscillating(wider, {6.0909, 5.9624, 6.0042}, {2., 2.}, round_off);
  check::is_true("oscillating", oscillating.behaviour == Behaviour::oscillatory &&
                                    std::isnan(oscillating.order) &&
                                    oscillating.description() == "oscillates");
  check::is_true("oscillating: the finest value within the range",
                 oscillating.limit == 6.0042 &&
                     std::abs(oscillating.estimated_error - 0.1285) < 1e-12);
}

void implausible_orders()
{
  const GridConvergence fast = power({1., 0.5, 0.25}, 1., 7.);
  check::absolute("too high: observed", fast.order, 7., 1e-8);
  // Extrapolated with order 4: f1 - f2 = 4^-7 - 2^-7.
  const double difference = std::pow(0.25, 7) - std::pow(0.5, 7);
  check::absolute("too high: limit", fast.limit, 3. + std::pow(0.25, 7) + difference / 15., 1e-12);
  check::absolute("too high: error", fast.estimated_error, 3. * std::abs(difference) / 15., 1e-12);
  check::is_true("too high: said", !fast.order_plausible && fast.description() == "7.00 ?");
  const GridConvergence slow = power({1., 0.5, 0.25}, 1., 0.1);
  check::absolute("too low: observed", slow.order, 0.1, 1e-8);
  const double slow_difference = std::pow(0.25, 0.1) - std::pow(0.5, 0.1);
  check::absolute("too low: error", slow.estimated_error,
                  3. * std::abs(slow_difference) / (std::sqrt(2.) - 1.), 1e-9);
}

void no_order()
{
  const GridConvergence two({1., 0.5}, {1.04, 1.01}, {2., 4.}, round_off);
  check::is_true("two meshes", two.behaviour == Behaviour::two_meshes && std::isnan(two.order));
  check::absolute("two meshes: limit", two.limit, 1., 1e-12);
  check::absolute("two meshes: error", two.estimated_error, 0.03, 1e-12);

  const GridConvergence diverging({1., 0.5, 0.25}, {1., 2., 3.}, {2., 4.}, round_off);
  check::is_true("equal differences", diverging.behaviour == Behaviour::divergent &&
                                          std::isnan(diverging.limit) &&
                                          std::isnan(diverging.estimated_error));
  // The differences shrink, but the logarithm of the cell size, which has no limit, would let them
  // shrink more: ln 4 to ln 2.
  check::is_true(
      "differences that shrink too slowly",
      GridConvergence({1., 0.25, 0.125}, {0., 1.2, 1.2 + std::log(2.)}, {2., 4.}, round_off)
              .behaviour == Behaviour::divergent);

  const GridConvergence settled({1., 0.5, 0.25}, {0.3, 0.1, 0.1 + 1e-15}, {2., 4.}, round_off);
  check::is_true("settled", settled.behaviour == Behaviour::settled &&
                                settled.limit == 0.1 + 1e-15 && settled.estimated_error < 2e-15 &&
                                settled.description() == "settled");
  const GridConvergence one({1.}, {5.}, {2., 4.}, round_off);
  check::is_true("one mesh", one.behaviour == Behaviour::too_few && std::isnan(one.limit));
  check::throws<std::invalid_argument>(
      "cells that do not decrease",
      []() {
        GridConvergence({1., 1.}, {1., 2.}, {2., 4.}, round_off);
      },
      "decrease");
  check::throws<std::invalid_argument>(
      "unequally many",
      []() {
        GridConvergence({1., 0.5}, {1.}, {2., 4.}, round_off);
      },
      "as many");
}
} // namespace

UNIT_TEST(grid_convergence)
{
  known_orders();
  published();
  implausible_orders();
  no_order();
}
} // namespace test_of_grid_convergence
