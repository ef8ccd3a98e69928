#ifndef continua_program_parameter_catalogue_h
#define continua_program_parameter_catalogue_h

#include <string>
#include <vector>

namespace Continua
{
/// One entry of a parameter file, as the code that reads it declares it.
struct CatalogueEntry
{
  std::vector<std::string> section; ///< "Materials", "<region>"
  std::string key;
  std::string default_value; ///< with its unit; empty where there is none
  std::string values;        ///< what is accepted, in words
  std::string unit;          ///< "Pa", "1"; empty for what is no quantity
  std::string text;          ///< what it means, with the unit
  std::string condition; ///< the choices with which it exists: "Waveform = table"; empty: always

  bool operator==(const CatalogueEntry &other) const;
};

/// The entries of one row of a table of types, or those that all of a section's types share.
struct CataloguePart
{
  std::string type;                ///< empty for what is shared
  std::string description;         ///< of the type, or of the section
  std::vector<std::string> models; ///< the values of Model with which it exists
  /// Of a geometry: the names of its regions and boundaries, a line for each set of models.
  std::vector<std::string> names;
  std::vector<CatalogueEntry> entries;
};

/// A section of the documentation.
struct CatalogueSection
{
  std::string title;
  std::string type_key; ///< the key that chooses a type; empty where there are none
  CataloguePart shared;
  std::vector<CataloguePart> types;
};

/**
 * Every entry that exists. Nothing is listed here by hand but the functions that read the sections
 * of a file: each is called without a file once for every type and every choice among its entries,
 * and what it then declares is the catalogue, made once. An entry stands where it was declared
 * first.
 */
const std::vector<CatalogueSection> &parameter_catalogue();
} // namespace Continua

#endif
