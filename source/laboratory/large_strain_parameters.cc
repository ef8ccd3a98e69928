#include <continua/laboratory/large_strain_parameters.h>

#include <continua/base/csv_table.h>

#include <algorithm>
#include <cctype>

namespace Continua
{
namespace
{
StretchTable read_stretch_table(ParameterSection &section,
                                const std::string &word,
                                const HomogeneousTestType type)
{
  const bool is_shear = type == HomogeneousTestType::shear;
  const std::string strain_measure = is_shear ? "shear" : "stretch";
  std::string key = word + " table";
  key[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(key[0])));
  StretchTable result;
  result.type = type;
  section.add_input_file(
      key, result.file,
      "A csv file of a measured " + word + " test with the columns " + strain_measure +
          " [1] and stress (force over the undeformed area), units in its header; "
          "the constants of the law are fitted to all tables.");
  if (result.file.empty())
    return result;
  const CsvTable table(result.file, strain_measure + " [1], stress [kPa]");
  const std::size_t strain_measure_column = table.find(strain_measure),
                    stress_column = table.find("stress");
  result.strain_measures = table.values(strain_measure_column, Dimensions::none);
  result.stresses = table.values(stress_column, Dimensions::pressure);
  table.require_rows(2);
  // Beyond every solid there is, and where exponentials can no longer be held.
  constexpr double largest_stretch = 100.;
  for (std::size_t row = 0; row < result.strain_measures.size(); ++row)
    if (!is_shear && (result.strain_measures[row] < 1. / largest_stretch ||
                      result.strain_measures[row] > largest_stretch))
      table.refuse(row, strain_measure_column,
                   "a stretch is the length over the undeformed one, 1 without strain",
                   "Give values between 0.01 and 100; a strain e is the stretch 1 + e");
    else if (is_shear && std::abs(result.strain_measures[row]) > largest_stretch)
      table.refuse(row, strain_measure_column, "the amount of shear is too large",
                   "Give values between -100 and 100");
  if (std::all_of(result.stresses.begin(), result.stresses.end(),
                  [](const double stress) { return stress == 0.; }))
    table.refuse(0, stress_column, "all stresses are 0", "Give the stresses that were measured");
  return result;
}
} // namespace

std::vector<std::string> LargeStrainParameters::test_names()
{
  return {"uniaxial",  "equibiaxial",        "planar",          "shear",
          "inflation", "stretch relaxation", "shear relaxation"};
}

void LargeStrainParameters::read(ParameterSection &section, const std::vector<std::string> &tests)
{
  const auto has = [&tests](const std::string &test)
  { return std::find(tests.begin(), tests.end(), test) != tests.end(); };
  section.add("Smallest stretch", smallest_stretch, Dimensions::none,
              "Where curves over the stretch begin: length over undeformed length.",
              Range{0.01, 100.});
  section.add("Largest stretch", largest_stretch, Dimensions::none,
              "Where these curves end. Of an inflation: of the circumference.", Range{0.01, 100.});
  section.add("Largest shear", largest_shear, Dimensions::none,
              "Amount of shear, the tangent of its angle, at which the curve of the test shear "
              "ends.",
              Range{0., 100., true, false});
  section.add("Points", n_points, "Rows of each curve [1].", 2, 100000);
  const Words<CuttingDirection> directions = {
      {"axial", CuttingDirection::axial}, {"circumferential", CuttingDirection::circumferential}};
  add_choice(section, "Direction", direction, directions,
             "The direction along which a specimen with fibres is pulled, in all tests but "
             "inflation.");
  section.add("Axial stretch", axial_stretch, Dimensions::none,
              "Stretch along the axis at which a tube is held during an inflation.",
              Range{0.01, 100.});
  section.add("Radius", radius, Dimensions::length,
              "Radius of the undeformed tube, to the middle of its wall. Required by inflation.",
              Range::positive());
  section.add(
      "Wall thickness", wall_thickness, Dimensions::length,
      "Thickness of its undeformed wall; the stress is taken as even across it. Required by "
      "inflation.",
      Range::positive());
  section.add("Held stretch", held_stretch, Dimensions::none,
              "Stretch at which a stretch relaxation is held. Required by it.",
              Range{0., 100., true, false});
  section.add("Held shear", held_shear, Dimensions::none,
              "Amount of shear at which a shear relaxation is held. Required by it.",
              Range{0., 100., true, false});
  section.add("Loading time", loading_time, Dimensions::time,
              "Time within which the stretch or the shear of a relaxation rises evenly; 0: it is "
              "there at once.",
              Range::not_negative());
  for (const auto &[word, type] : homogeneous_test_words())
  {
    StretchTable table = read_stretch_table(section, word, type);
    if (!table.file.empty())
      tables.push_back(std::move(table));
  }
  if (smallest_stretch >= largest_stretch)
    section.refuse(section.given("Smallest stretch") ? "Smallest stretch" : "Largest stretch",
                   "the curve is empty",
                   "Give a smallest stretch (default 1) below the largest one (default 2)");
  if (has("inflation"))
  {
    section.require("Radius");
    section.require("Wall thickness");
    if (wall_thickness >= 2. * radius)
      section.refuse("Wall thickness", "the wall is thicker than the tube",
                     "Give less than twice the radius, which is that of the middle of the wall");
  }
  if (has("stretch relaxation"))
    section.require("Held stretch");
  if (has("shear relaxation"))
    section.require("Held shear");
}
} // namespace Continua
