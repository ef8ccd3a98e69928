#include <continua/continuum/compared_field.h>

namespace Continua
{
using namespace dealii;

std::vector<DistributedVector>
vectors_of(const ComparedField field,
           const Problem &problem,
           const DistributedVector &velocity,
           const DistributedVector &displacement,
           const std::function<DistributedVector(const DistributedVector &)> &ghosted,
           const std::function<DistributedVector(unsigned int)> &mixture)
{
  std::vector<DistributedVector> vectors;
  switch (field)
  {
  case ComparedField::velocity:
    vectors.push_back(ghosted(velocity));
    break;
  case ComparedField::displacement:
    vectors.push_back(ghosted(displacement));
    break;
  case ComparedField::pressure:
    break;
  case ComparedField::stress:
    for (unsigned int region = 0; region < problem.regions.size(); ++region)
      vectors.push_back(mixture(region));
  }
  return vectors;
}

template <int dim>
double squared_difference(const std::array<double, 6> &values,
                          const std::vector<Expression> &exact,
                          const Point<dim> &point,
                          const double time)
{
  double coordinates[3] = {0., 0., 0.};
  for (unsigned int c = 0; c < dim; ++c)
    coordinates[c] = point[c];
  double square = 0.;
  for (unsigned int c = 0; c < exact.size(); ++c)
  {
    const double difference = values[c] - exact[c](coordinates, time);
    square += difference * difference;
  }
  return square;
}

template double squared_difference(const std::array<double, 6> &,
                                   const std::vector<Expression> &,
                                   const Point<2> &,
                                   double);
template double squared_difference(const std::array<double, 6> &,
                                   const std::vector<Expression> &,
                                   const Point<3> &,
                                   double);
} // namespace Continua
