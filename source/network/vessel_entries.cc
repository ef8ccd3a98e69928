#include <continua/network/vessel_entries.h>

#include <continua/base/csv_table.h>
#include <continua/base/required_entry.h>

#include <algorithm>
#include <memory>

namespace Continua
{
double VesselEntries::radius(const double z) const
{
  return radius_at_start + z / length * (radius_at_end - radius_at_start);
}

double VesselEntries::thickness(const double z) const
{
  return thickness_at_start + z / length * (thickness_at_end - thickness_at_start);
}

VesselEntries VesselEntries::read(ParameterSection section)
{
  VesselEntries vessel;
  vessel.name = section.name();
  section.add("From", vessel.from,
              "The node where the vessel starts, called as you like. Vessels whose ends are at the "
              "same node meet there. Required.");
  section.add("To", vessel.to, "The node where it ends. Required.");
  section.require("From");
  section.require("To");
  vessel.length =
      required_entry(section, "Length", Dimensions::length, "Of the vessel.", Range::positive());
  vessel.radius_at_start =
      required_entry(section, "Radius at start", Dimensions::length,
                     "Inner radius under the reference pressure.", Range::positive());
  vessel.radius_at_end = vessel.radius_at_start;
  section.add("Radius at end", vessel.radius_at_end, Dimensions::length,
              "The same at the end; between them it is linear. Left out: as at the start.",
              Range::positive());
  vessel.thickness_at_start =
      required_entry(section, "Wall thickness at start", Dimensions::length,
                     "Thickness of the wall under the reference pressure.", Range::positive());
  vessel.thickness_at_end = vessel.thickness_at_start;
  section.add("Wall thickness at end", vessel.thickness_at_end, Dimensions::length,
              "The same at the end; between them it is linear. Left out: as at the start.",
              Range::positive());
  section.add("Material", vessel.material,
              "Of the wall: the name of a solid of the section Materials, of type hookean, "
              "kelvin-voigt or prony. It stands in place of Young's modulus, and of the Poisson's "
              "ratio and the relaxation of the section Network.");
  if (vessel.material.empty())
    vessel.youngs_modulus = required_entry(section, "Young's modulus", Dimensions::pressure,
                                           "Of the wall, the long-term one. Required without a "
                                           "Material.",
                                           Range::positive());
  else if (section.given("Young's modulus"))
    section.refuse("Young's modulus", "the material '" + vessel.material + "' has one",
                   "Remove this or the Material");
  section.add("Rise", vessel.rise, Dimensions::length,
              "How much higher the end of the vessel is than its start, for the pressure of "
              "gravity.");
  vessel.refuse = [section](const std::string &key, const std::string &problem,
                            const std::string &remedy) { section.refuse(key, problem, remedy); };
  return vessel;
}

std::vector<VesselEntries> VesselEntries::read_table(const std::string &file)
{
  const auto table = std::make_shared<const CsvTable>(
      file, "name, from, to, length [mm], radius at start [mm], radius at end [mm], "
            "wall thickness at start [mm], wall thickness at end [mm], Young's modulus [kPa]");
  std::vector<VesselEntries> vessels(table->n_rows());
  table->require_rows(1);
  const auto texts = [&](const std::string &column, std::string VesselEntries::*member)
  {
    const std::vector<std::string> cells = table->texts(table->find(column));
    for (std::size_t row = 0; row < cells.size(); ++row)
      vessels[row].*member = cells[row];
  };
  texts("name", &VesselEntries::name);
  texts("from", &VesselEntries::from);
  texts("to", &VesselEntries::to);
  const auto numbers = [&](const std::string &name, double VesselEntries::*member,
                           const Dimension &dimension, const bool positive)
  {
    const std::size_t column = table->find(name);
    const std::vector<double> values = table->values(column, dimension);
    for (std::size_t row = 0; row < values.size(); ++row)
    {
      if (positive && !(values[row] > 0.))
        table->refuse(row, column, "is not positive", "Write a positive number");
      vessels[row].*member = values[row];
    }
  };
  numbers("length", &VesselEntries::length, Dimensions::length, true);
  numbers("radius at start", &VesselEntries::radius_at_start, Dimensions::length, true);
  numbers("radius at end", &VesselEntries::radius_at_end, Dimensions::length, true);
  numbers("wall thickness at start", &VesselEntries::thickness_at_start, Dimensions::length, true);
  numbers("wall thickness at end", &VesselEntries::thickness_at_end, Dimensions::length, true);
  numbers("Young's modulus", &VesselEntries::youngs_modulus, Dimensions::pressure, true);
  for (std::size_t column = 0; column < table->n_columns(); ++column)
    if (table->name(column) == "rise")
      numbers("rise", &VesselEntries::rise, Dimensions::length, false);
  for (std::size_t row = 0; row < vessels.size(); ++row)
    vessels[row].refuse =
        [table, row](const std::string &key, const std::string &problem, const std::string &remedy)
    {
      const std::string column = key == "From"   ? "from"
                                 : key == "To"   ? "to"
                                 : key == "Rise" ? "rise"
                                                 : "";
      table->refuse(row, column.empty() ? table->find("name") : table->find(column), problem,
                    remedy);
    };
  return vessels;
}
} // namespace Continua
