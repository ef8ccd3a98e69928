#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/base/units.h>
#include <continua/postprocess/field_writer.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>

namespace Continua
{
namespace
{
/// Writes a file through `write`; returns what went wrong, or nothing.
std::string write_stream(const std::string &file, const std::function<void(std::ostream &)> &write)
{
  errno = 0;
  std::ofstream stream(file);
  if (stream)
    write(stream);
  stream.flush();
  if (stream)
    return "";
  return "cannot write '" + file + "'" +
         (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string());
}

/// Throws RunError on all ranks if something went wrong on one of them.
void agree(const MPI_Comm communicator, const std::string &problem)
{
  for (const std::string &one : dealii::Utilities::MPI::all_gather(communicator, problem))
    if (!one.empty())
      throw RunError(one);
}

/// The value of an attribute in a line of XML; empty if it has none.
std::string attribute(const std::string &line, const std::string &key)
{
  const std::size_t begin = line.find(' ' + key + "=\"");
  if (begin == std::string::npos)
    return "";
  const std::size_t first = begin + key.size() + 3;
  return line.substr(first, line.find('"', first) - first);
}

/// The entries of a list of times and files, as write_list() writes it, up to `last_time`.
std::vector<std::pair<double, std::string>> read_list(const std::string &file,
                                                      const double last_time)
{
  std::vector<std::pair<double, std::string>> entries;
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line))
  {
    if (line.find("<DataSet") == std::string::npos)
      continue;
    const std::string time_text = attribute(line, "timestep");
    const std::string data_file = attribute(line, "file");
    double time = 0.;
    const char *const end = time_text.data() + time_text.size();
    const std::from_chars_result result = std::from_chars(time_text.data(), end, time);
    if (result.ec != std::errc() || result.ptr != end || data_file.empty())
      throw RunError("cannot continue '" + file + "': the line '" + line + "' is damaged");
    if (time <= last_time)
      entries.emplace_back(time, data_file);
  }
  return entries;
}
} // namespace

template <int dim>
FieldWriter<dim>::FieldWriter(const MPI_Comm communicator,
                              const std::string &folder,
                              const unsigned int subdivisions,
                              const bool higher_order_cells,
                              const std::string &name)
    : communicator(communicator),
      folder(folder),
      subdivisions(subdivisions),
      higher_order_cells(higher_order_cells),
      name(name)
{
}

template <int dim>
void FieldWriter<dim>::resume(const double restart_time)
{
  // Times in the list are those of the steps but for round-off.
  const double last_time = restart_time + 1e-12 * std::abs(restart_time);
  on_writing_rank(communicator,
                  [&]()
                  {
                    const std::string file = folder + "/fields.pvd";
                    if (!std::ifstream(file))
                      return;
                    entries = read_list(file, last_time);
                    write_list();
                  });
  entries = dealii::Utilities::MPI::broadcast(communicator, entries);
}

template <int dim>
void FieldWriter<dim>::write(ContinuumSolver<dim> &solver, const double time)
{
  if (!entries.empty() && entries.back().first == time)
    entries.pop_back();
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  const std::string base =
      name + "-" + dealii::Utilities::int_to_string(static_cast<unsigned int>(entries.size()), 5);
  const auto piece = [&](const unsigned int rank)
  { return base + (n_ranks > 1 ? "." + std::to_string(rank) : "") + ".vtu"; };
  const std::string path = folder + "/fields/";

  dealii::DataOut<dim> data_out;
  units = solver.add_output(data_out);
  dealii::DataOutBase::VtkFlags flags;
  flags.time = time;
  flags.cycle = static_cast<unsigned int>(entries.size());
  flags.print_date_and_time = false;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.write_higher_order_cells = higher_order_cells && subdivisions > 1;
  flags.physical_units = units;
  data_out.set_flags(flags);
  data_out.build_patches(solver.mapping(), subdivisions, dealii::DataOut<dim>::curved_inner_cells);

  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  agree(communicator, write_stream(path + piece(rank),
                                   [&](std::ostream &stream) { data_out.write_vtu(stream); }));
  std::string file = piece(0);
  if (n_ranks > 1)
  {
    file = base + ".pvtu";
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < n_ranks; ++r)
      pieces.push_back(piece(r));
    std::string problem;
    if (is_writing_rank(communicator))
      problem = write_stream(path + file, [&](std::ostream &stream)
                             { data_out.write_pvtu_record(stream, pieces); });
    agree(communicator, problem);
  }
  entries.emplace_back(time, "fields/" + file);
  on_writing_rank(communicator, [&]() { write_list(); });
}

template <int dim>
void FieldWriter<dim>::write_list() const
{
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                     "  <Collection>\n";
  for (const auto &[time, file] : entries)
    text += "    <DataSet timestep=\"" + shortest_number(time) + "\" part=\"0\" file=\"" + file +
            "\"/>\n";
  text += "  </Collection>\n</VTKFile>\n";
  write_file_atomically(folder + "/fields.pvd", text);
}

template <int dim>
void FieldWriter<dim>::finish(Summary &summary) const
{
  if (!units.empty())
    summary.set("field units", units);
}

template class FieldWriter<2>;
template class FieldWriter<3>;
} // namespace Continua
