#include "measurement.h"

#include <continua/base/version.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <time.h>

namespace Benchmarks
{
double median(std::vector<double> values)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double wall_time(const std::function<void()> &function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double processor_time(const std::function<void()> &function)
{
  const auto now = []()
  {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  function();
  return now() - start;
}

Triad::Triad() : a((64u << 20) / sizeof(double), 0.), b(a.size(), 1.), c(a.size(), 2.) {}

double Triad::bandwidth()
{
  const double time = processor_time(
      [this]()
      {
        for (std::size_t i = 0; i < a.size(); ++i)
          a[i] = b[i] + 3. * c[i];
      });
  if (a[a.size() / 2] != 7.)
    throw std::runtime_error("the triad is wrong");
  return 3. * static_cast<double>(a.size() * sizeof(double)) / time;
}

std::string processor()
{
  std::ifstream stream("/proc/cpuinfo");
  std::string line;
  while (std::getline(stream, line))
    if (line.compare(0, 10, "model name") == 0)
      return line.substr(line.find(':') + 2);
  return "unknown";
}

double load()
{
  double value = 0.;
  std::ifstream("/proc/loadavg") >> value;
  return value;
}

std::string number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

Report::Report(std::string title) : title(std::move(title)) {}

void Report::line(const std::string &text)
{
  lines.push_back(text);
}

void Report::start_table(const std::string &heading, const std::vector<std::string> &columns)
{
  tables.push_back({heading, {columns}});
}

void Report::row(const std::vector<std::string> &cells)
{
  Table &table = tables.back();
  if (cells.size() != table.rows.front().size())
    throw std::logic_error("a row of '" + table.heading + "' has another number of cells");
  table.rows.push_back(cells);
}

std::string Report::text() const
{
  std::ostringstream out;
  out << title << "\n\n";
  for (const std::string &line : lines)
    out << line << '\n';
  for (const Table &table : tables)
  {
    out << '\n' << table.heading << '\n';
    std::vector<std::size_t> widths(table.rows.front().size(), 0);
    for (const auto &row : table.rows)
      for (std::size_t c = 0; c < row.size(); ++c)
        widths[c] = std::max(widths[c], row[c].size());
    for (const auto &row : table.rows)
    {
      for (std::size_t c = 0; c < row.size(); ++c)
        out << std::setw(static_cast<int>(widths[c]) + (c > 0 ? 2 : 0)) << row[c];
      out << '\n';
    }
  }
  return out.str();
}

std::string Report::markdown() const
{
  std::ostringstream out;
  out << "# " << title << "\n\n";
  for (const std::string &line : lines)
    out << "* " << line << '\n';
  for (const Table &table : tables)
  {
    out << "\n## " << table.heading << "\n\n";
    for (std::size_t r = 0; r < table.rows.size(); ++r)
    {
      out << '|';
      for (const std::string &cell : table.rows[r])
        out << ' ' << cell << " |";
      out << '\n';
      if (r == 0)
      {
        out << '|';
        for (std::size_t c = 0; c < table.rows[r].size(); ++c)
          out << "---:|";
        out << '\n';
      }
    }
  }
  return out.str();
}

void Report::finish(const std::string &path) const
{
  std::cout << text() << std::flush;
  save(path);
}

void Report::save(const std::string &path) const
{
  for (const auto &[suffix, content] :
       {std::make_pair(".txt", text()), std::make_pair(".md", markdown())})
  {
    std::ofstream stream(path + suffix);
    stream << content;
    stream.flush();
    if (!stream)
      throw std::runtime_error("cannot write " + path + suffix);
  }
}

void describe_machine(Report &report)
{
  report.line("processor: " + processor() + ", " +
              std::to_string(std::thread::hardware_concurrency()) +
              " cores seen, one used; load before the start " + number(load()));
}

void describe_libraries(Report &report)
{
  const auto libraries = Continua::library_versions();
  report.line("BLAS: " + libraries.at("BLAS") +
              (Continua::blas_is_reference() ? " (reference: slow)" : ""));
  report.line("Continua " + Continua::version() + " (" + Continua::revision() +
              (Continua::revision_is_dirty() ? ", changed" : "") + "), deal.II " +
              libraries.at("deal.II") + ", MUMPS " + libraries.at("MUMPS") + ", CHOLMOD " +
              libraries.at("CHOLMOD"));
}

int main_of(int argc,
            char **argv,
            const std::function<void(const std::string &, const std::string &, bool)> &run,
            const std::string &option)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool has_option = !option.empty() && argc == 4 && argv[3] == option;
  if (argc != 3 && !has_option)
  {
    std::cerr << "usage: " << argv[0] << " OUTPUT SOURCE_DIRECTORY"
              << (option.empty() ? "" : " [" + option + "]") << std::endl;
    return 2;
  }
  try
  {
    run(argv[1], argv[2], has_option);
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
} // namespace Benchmarks
