#ifndef continua_tests_postprocess_text_file_h
#define continua_tests_postprocess_text_file_h

#include <continua/base/summary.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

/// Rank 0 writes, all wait for it.
inline void write_text(const std::string &file, const std::string &text)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::ofstream(file) << text;
  MPI_Barrier(MPI_COMM_WORLD);
}

inline std::string read_text(const std::string &file)
{
  MPI_Barrier(MPI_COMM_WORLD);
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The value of a quantity; NaN if there is none.
inline double
quantity(const Continua::Summary &summary, const std::string &name, const std::string &probe = "")
{
  for (const Continua::Quantity &entry : summary.quantities())
    if (entry.name == name && entry.probe == probe)
      return entry.value;
  return std::nan("");
}

/// Its unit.
inline std::string quantity_unit(const Continua::Summary &summary, const std::string &name)
{
  for (const Continua::Quantity &entry : summary.quantities())
    if (entry.name == name)
      return entry.unit;
  return "";
}

#endif
