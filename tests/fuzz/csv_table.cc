// Tables: refused with an InputError, or read to columns of finite numbers, as many as there are
// rows.

#include <continua/base/csv_table.h>

#include "input_file.h"

#include <cmath>

using namespace Continua;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string input(reinterpret_cast<const char *>(data), size);
  try
  {
    const CsvTable table(Fuzz::input_file(input, "input.csv"), "time [ms], pressure [mmHg]");
    Fuzz::require(table.n_columns() > 0, "a table has no columns");
    for (std::size_t column = 0; column < table.n_columns(); ++column)
      for (const Dimension &dimension :
           {Dimensions::time, Dimensions::pressure, Dimensions::length, Dimensions::none})
        try
        {
          const std::vector<double> values = table.values(column, dimension);
          Fuzz::require(values.size() == table.n_rows(), "a column lacks numbers");
          for (const double value : values)
            Fuzz::require(std::isfinite(value), "a table has a number that is not finite");
          const std::vector<double> increasing =
              table.increasing_values(column, dimension, "time", "later");
          Fuzz::require(increasing == values, "a column is read in two ways");
        }
        catch (const InputError &)
        {
        }
    table.find(table.name(0));
  }
  catch (const InputError &)
  {
  }
  return 0;
}
