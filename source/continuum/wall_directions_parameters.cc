#include <continua/continuum/wall_directions_parameters.h>

#include <continua/base/input_error.h>
#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/base/words.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace Continua
{
using namespace dealii;

namespace
{
std::set<unsigned int> read_boundaries(ParameterSection &section,
                                       const std::string &key,
                                       const std::vector<std::string> &boundaries,
                                       const std::string &text)
{
  std::vector<std::string> names;
  section.add(key, names, text);
  std::set<unsigned int> ids;
  for (const std::string &name : names)
    ids.insert(find_name(section, key, name, boundaries));
  return ids;
}

/// The part of a vector across a unit vector, of length 1; false where there is none.
bool set_across(const Tensor<1, 3> &unit, Tensor<1, 3> &vector)
{
  const double size = vector.norm();
  vector -= (vector * unit) * unit;
  const double rest = vector.norm();
  // NaN fails the comparison.
  if (!(rest > 1e-8 * size))
    return false;
  vector /= rest;
  return true;
}

/// Whether they are partly in the plane of two dimensions and partly across it.
bool is_oblique_to_plane(const TubeDirections &directions)
{
  const double tolerated = 1e-8;
  double in_plane = 0.;
  for (const Tensor<1, 3> &direction : {directions.axis, directions.circumference})
    in_plane += std::min(direction[0] * direction[0] + direction[1] * direction[1],
                         direction[2] * direction[2]);
  return in_plane > tolerated * tolerated;
}
} // namespace

void WallDirectionsParameters::read(ParameterSection section,
                                    const std::vector<std::string> &boundaries,
                                    const Model model)
{
  add_choice(
      section, "Type", type,
      {{"straight axis", Type::straight_axis},
       {"potentials", Type::potentials},
       {"expressions", Type::expressions}},
      "What is along and around the wall, for fibres and prestretch: straight axis - that of "
      "a tube about the x axis, in plane strain about the line through the origin across the "
      "plane; potentials - by the slopes of two solutions of Laplace's equation, one from the "
      "inside of the wall to its outside, one from one end to the other; expressions - as the "
      "entries Axis and Circumference say.");
  const bool by_potentials = type == Type::potentials, by_expressions = type == Type::expressions,
             is_solid = model == Model::three_dimensional;
  inside = read_boundaries(section, "Inside", boundaries,
                           "For Type = potentials: names of the boundaries inside the wall.");
  outside = read_boundaries(section, "Outside", boundaries,
                            "For Type = potentials: names of the boundaries outside the wall.");
  begin =
      read_boundaries(section, "Begin", boundaries,
                      "For Type = potentials in three dimensions: names of the boundaries where "
                      "the wall begins.");
  end = read_boundaries(section, "End", boundaries,
                        "For Type = potentials in three dimensions: names of the boundaries where "
                        "the wall ends.");
  add_expressions(section, "Axis", axis, 3, Dimensions::none,
                  "For Type = expressions: components of a vector along the wall, of any length "
                  "[1]; in two dimensions the third one is across the plane.");
  add_expressions(section, "Circumference", circumference, 3, Dimensions::none,
                  "For Type = expressions: components of a vector around the wall, of any length "
                  "[1]; its part along the Axis is left out.");
  for (const char *const key : {"Inside", "Outside", "Begin", "End"})
  {
    const bool is_of_ends = key[0] == 'B' || key[0] == 'E',
               is_used = by_potentials && (is_solid || !is_of_ends);
    if (section.given(key) && !is_used)
      section.refuse(key,
                     by_potentials ? "in two dimensions the wall across the plane of its slope "
                                     "needs no potential along it"
                                   : "this entry is for Type = potentials",
                     by_potentials ? "Remove the entry"
                                   : "Remove the entry, or set Type = potentials");
    if (is_used && !section.given(key))
      section.refuse_missing(std::string("Type = potentials needs the entry ") + key,
                             "Give names of boundaries");
  }
  for (const char *const key : {"Axis", "Circumference"})
  {
    if (section.given(key) && !by_expressions)
      section.refuse(key, "this entry is for Type = expressions",
                     "Remove the entry, or set Type = expressions");
    if (by_expressions && !section.given(key))
      section.refuse_missing(std::string("Type = expressions needs the entry ") + key,
                             "Give three components");
  }
  for (const auto *const components : {&axis, &circumference})
    for (const Expression &component : *components)
      if (component.depends_on_time())
        section.refuse("", "a direction depends on t", "Write it as a function of x, y, z");
  for (const auto &[first, second, key] :
       {std::tuple(&inside, &outside, "Outside"), std::tuple(&begin, &end, "End")})
    for (const unsigned int id : *first)
      if (second->count(id) > 0)
        section.refuse(key, "the boundary '" + boundaries[id] + "' is at both ends of a potential",
                       "Name other boundaries");
}

template <int dim>
TubeDirections WallDirectionsParameters::find(const Model model,
                                              const Point<dim> &place,
                                              const Tensor<2, 3> &slopes) const
{
  if (type == Type::straight_axis)
    return tube_directions_at<dim>(model, place);
  TubeDirections directions;
  bool has_directions = true;
  if (type == Type::expressions)
  {
    double coordinates[3] = {0., 0., 0.};
    for (unsigned int c = 0; c < dim; ++c)
      coordinates[c] = place[c];
    for (unsigned int c = 0; c < 3; ++c)
    {
      directions.axis[c] = axis[c](coordinates, 0.);
      directions.circumference[c] = circumference[c](coordinates, 0.);
    }
    has_directions = set_across(Tensor<1, 3>(), directions.axis) &&
                     set_across(directions.axis, directions.circumference);
  }
  else
  {
    Tensor<1, 3> normal = slopes[1];
    has_directions = set_across(Tensor<1, 3>(), normal);
    if (dim == 3)
    {
      directions.axis = slopes[0];
      has_directions = has_directions && set_across(normal, directions.axis);
      directions.circumference = cross_product_3d(normal, directions.axis);
    }
    else
    {
      Tensor<1, 3> across_plane;
      across_plane[2] = 1.;
      const Tensor<1, 3> in_plane = cross_product_3d(across_plane, normal);
      const bool is_round = model == Model::axisymmetric;
      directions.axis = is_round ? in_plane : across_plane;
      directions.circumference = is_round ? across_plane : in_plane;
    }
  }
  return has_directions ? directions : TubeDirections();
}

template <int dim>
TubeDirections WallDirectionsParameters::at(const Model model,
                                            const Point<dim> &place,
                                            const Tensor<2, 3> &slopes) const
{
  const TubeDirections directions = find(model, place, slopes);
  const bool exist = directions.axis.norm_square() > 0.,
             is_oblique = dim == 2 && exist && is_oblique_to_plane(directions);
  if (exist && !is_oblique)
    return directions;
  std::ostringstream text;
  text << "the section Wall directions gives " << (is_oblique ? "an oblique" : "no")
       << " direction at (";
  for (unsigned int c = 0; c < dim; ++c)
    text << (c == 0 ? "" : ", ") << place[c];
  text << ") m: ";
  if (is_oblique)
    text << "in two dimensions one of Axis and Circumference lies in the plane and the other one "
            "across it";
  else if (type == Type::expressions)
    text << "Axis or Circumference is zero there, or they are parallel";
  else
    text << "a potential has no slope there, or both have the same one; name boundaries on both "
            "sides "
            "of all regions with fibres or prestretch, or set Type = expressions";
  throw RunError(text.str());
}

template TubeDirections
WallDirectionsParameters::find(Model, const Point<2> &, const Tensor<2, 3> &) const;
template TubeDirections
WallDirectionsParameters::find(Model, const Point<3> &, const Tensor<2, 3> &) const;
template TubeDirections
WallDirectionsParameters::at(Model, const Point<2> &, const Tensor<2, 3> &) const;
template TubeDirections
WallDirectionsParameters::at(Model, const Point<3> &, const Tensor<2, 3> &) const;
} // namespace Continua
