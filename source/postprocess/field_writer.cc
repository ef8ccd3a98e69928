#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/output_files.h>
#include <continua/base/units.h>
#include <continua/postprocess/field_writer.h>
#include <continua/postprocess/view_in_paraview.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

namespace Continua
{
namespace
{
/// What the names of a state's files begin with.
const std::string prefix = "solution-";

/// Writes a file through `write`; returns what went wrong, or nothing.
std::string write_stream(const std::string &file, const std::function<void(std::ostream &)> &write)
{
  const std::string problem = "cannot write '" + file + "'";
  try
  {
    errno = 0;
    std::ofstream stream;
    // The system's reason is known only as soon as the disk refuses.
    stream.exceptions(std::ios::badbit | std::ios::failbit);
    stream.open(file);
    write(stream);
    stream.close();
  }
  catch (const std::ios_base::failure &)
  {
    return problem + (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string());
  }
  catch (const std::exception &error)
  {
    return problem + ": " + error.what();
  }
  return "";
}

/// What MPI says in an exception of deal.II, after a colon; empty if nothing is found.
std::string reason_of_mpi(const std::string &text)
{
  const std::string before = "provided by MPI is \"";
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos)
    return "";
  const std::size_t first = begin + before.size();
  return ": " + text.substr(first, text.find('"', first) - first);
}

/// The list is written anew with each of so many states. Of more states it may take a twentieth of
/// the time, since a list of n states that is written n times costs n^2.
constexpr std::size_t states_listed_at_once = 100;
constexpr int largest_wait = 20;

const std::string list_head = "<?xml version=\"1.0\"?>\n"
                              "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                              "  <Collection>\n";

std::string line_of_list(const std::pair<double, std::string> &entry)
{
  return "    <DataSet timestep=\"" + shortest_number(entry.first) + "\" part=\"0\" file=\"" +
         entry.second + "\"/>\n";
}

/// Throws RunError on all ranks if something went wrong on one of them.
void agree(const MPI_Comm communicator, const std::string &problem)
{
  if (dealii::Utilities::MPI::max(problem.empty() ? 0 : 1, communicator) == 0)
    return;
  for (const std::string &one : all_gather(communicator, problem))
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
  const auto refuse_unread = [&]()
  {
    if (!stream.is_open() || stream.bad())
      throw RunError("cannot continue '" + file + "': it cannot be read");
  };
  refuse_unread();
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
    {
      std::string text = "cannot continue '";
      throw RunError(text.append(file).append("': the line '").append(line).append("' is damaged"));
    }
    if (time <= last_time)
      entries.emplace_back(time, data_file);
  }
  refuse_unread();
  return entries;
}
} // namespace

template <int dim>
FieldWriter<dim>::FieldWriter(const MPI_Comm communicator,
                              const std::string &folder,
                              const unsigned int subdivisions,
                              const bool higher_order_cells,
                              const unsigned int files_per_state)
    : communicator(communicator),
      folder(folder),
      subdivisions(subdivisions),
      higher_order_cells(higher_order_cells),
      files_per_state(files_per_state)
{
}

template <int dim>
void FieldWriter<dim>::open(ContinuumSolver<dim> &solver,
                            const std::string & /*folder*/,
                            const bool is_due)
{
  if (is_due)
    write(solver, 0.);
}

template <int dim>
void FieldWriter<dim>::resume(ContinuumSolver<dim> & /*solver*/,
                              const std::string & /*folder*/,
                              const double time)
{
  resume(time);
}

template <int dim>
void FieldWriter<dim>::record(const RecordedStep<dim> &step)
{
  if (!step.is_due)
    return;
  SectionTimer::Scope scope(step.log.timer(), "fields");
  write(step.solver, step.time);
}

template <int dim>
void FieldWriter<dim>::finish(const RecordedEnd<dim> &end)
{
  complete_list();
  finish(end.summary);
}

template <int dim>
void FieldWriter<dim>::resume(const double restart_time)
{
  // Times in the list are those of the steps but for round-off.
  const double last_time = restart_time + 1e-12 * std::abs(restart_time);
  on_writing_rank(communicator,
                  [&]()
                  {
                    const std::string file = output_file(folder, "fields.pvd");
                    std::error_code unknown;
                    if (!std::filesystem::exists(file, unknown) && !unknown)
                      return;
                    entries = read_list(file, last_time);
                    write_list();
                    remove_later_states();
                  });
  std::vector<double> times;
  std::vector<std::string> files;
  for (const auto &[time, file] : entries)
  {
    times.push_back(time);
    files.push_back(file);
  }
  times = broadcast(communicator, times);
  files = broadcast(communicator, files);
  entries.clear();
  for (std::size_t i = 0; i < times.size(); ++i)
    entries.emplace_back(times[i], files[i]);
}

template <int dim>
void FieldWriter<dim>::remove_later_states() const
{
  std::error_code error;
  std::vector<std::filesystem::path> later;
  for (const auto &entry : std::filesystem::directory_iterator(folder + "/fields", error))
  {
    const std::string name = entry.path().filename().string();
    unsigned int number = 0;
    if (name.compare(0, prefix.size(), prefix) == 0 &&
        std::from_chars(name.data() + prefix.size(), name.data() + name.size(), number).ec ==
            std::errc() &&
        number >= entries.size())
      later.push_back(entry.path());
  }
  // A file that cannot be removed is in no list and is written over.
  for (const auto &path : later)
    std::filesystem::remove(path, error);
}

template <int dim>
std::string FieldWriter<dim>::write_together(dealii::DataOut<dim> &data_out,
                                             const std::string &file,
                                             const unsigned int group) const
{
  MPI_Comm of_group;
  const int error = MPI_Comm_split(communicator, static_cast<int>(group), 0, &of_group);
  AssertThrowMPI(error);
  std::string problem;
  try
  {
    data_out.write_vtu_in_parallel(file, of_group);
  }
  catch (const std::exception &error)
  {
    problem = "cannot write '" + file + "'" + reason_of_mpi(error.what());
  }
  MPI_Comm_free(&of_group);
  return problem;
}

template <int dim>
void FieldWriter<dim>::write(ContinuumSolver<dim> &solver, const double time)
{
  if (!entries.empty() && entries.back().first == time)
    entries.pop_back();
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  const bool together = files_per_state > 0 && files_per_state < n_ranks;
  const unsigned int n_files = together ? files_per_state : n_ranks;
  const std::string base =
      prefix + dealii::Utilities::int_to_string(static_cast<unsigned int>(entries.size()), 5);
  const auto piece = [&](const unsigned int number)
  { return base + (n_files > 1 ? "." + std::to_string(number) : "") + ".vtu"; };
  const std::string path = output_file(folder, "fields/");

  dealii::DataOut<dim> data_out;
  units = solver.add_output(data_out);
  dealii::DataOutBase::VtkFlags flags;
  flags.time = time;
  flags.cycle = static_cast<unsigned int>(entries.size());
  flags.print_date_and_time = false;
  // The name of this type depends on the version of deal.II.
  flags.compression_level = decltype(flags.compression_level)::best_speed;
  flags.write_higher_order_cells = higher_order_cells && subdivisions > 1;
  flags.physical_units = units;
  data_out.set_flags(flags);
  data_out.build_patches(solver.mapping(), subdivisions, dealii::DataOut<dim>::curved_inner_cells);

  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  // Ranks that write together follow each other.
  const auto number = static_cast<unsigned int>(std::uint64_t(rank) * n_files / n_ranks);
  const std::string own = path + piece(number);
  not_flushed.insert(own);
  agree(communicator,
        together ? write_together(data_out, own, number)
                 : write_stream(own, [&](std::ostream &stream) { data_out.write_vtu(stream); }));
  std::string file = piece(0);
  if (n_files > 1)
  {
    file = base + ".pvtu";
    std::vector<std::string> pieces;
    for (unsigned int i = 0; i < n_files; ++i)
      pieces.push_back(piece(i));
    std::string problem;
    if (is_writing_rank(communicator))
    {
      not_flushed.insert(path + file);
      problem = write_stream(path + file, [&](std::ostream &stream)
                             { data_out.write_pvtu_record(stream, pieces); });
    }
    agree(communicator, problem);
  }
  entries.emplace_back(time, "fields/" + file);
  on_writing_rank(
      communicator,
      [&]()
      {
        const auto since = Clock::now() - list_is_written_at;
        list_is_behind = true;
        if (entries.size() <= states_listed_at_once || since > largest_wait * duration_of_list)
          write_list();
        const std::string view = output_file(folder, "view-in-paraview.py");
        std::error_code unknown; // without its place the script is of use, too
        if (!has_view)
          write_file_atomically(
              view, view_in_paraview(
                        std::filesystem::absolute(view, unknown).lexically_normal().string()));
        has_view = true;
      });
}

template <int dim>
FieldWriter<dim>::~FieldWriter()
{
  // Of a run that fails, too, all states are to be found.
  try
  {
    if (list_is_behind)
      write_list();
  }
  catch (const std::exception &)
  {
  }
}

template <int dim>
void FieldWriter<dim>::complete_list()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (list_is_behind)
                      write_list();
                  });
}

template <int dim>
void FieldWriter<dim>::write_list()
{
  const auto start = Clock::now();
  std::string text = list_head;
  for (const auto &entry : entries)
    text += line_of_list(entry);
  text += "  </Collection>\n</VTKFile>\n";
  write_file_atomically(output_file(folder, "fields.pvd"), text);
  list_is_behind = false;
  list_is_written_at = Clock::now();
  duration_of_list = list_is_written_at - start;
}

template <int dim>
void FieldWriter<dim>::flush_to_disk()
{
  complete_list();
  std::string problem;
  try
  {
    // Who has moved a file away has taken care of it.
    for (const std::string &file : not_flushed)
      if (std::filesystem::exists(file))
        Continua::flush_to_disk(file);
    if (!not_flushed.empty())
      Continua::flush_to_disk(output_file(folder, "fields"));
  }
  catch (const std::exception &error)
  {
    problem = error.what();
  }
  agree(communicator, problem);
  not_flushed.clear();
}

template <int dim>
std::optional<WrittenTable> FieldWriter<dim>::table() const
{
  if (entries.empty() || !is_writing_rank(communicator))
    return std::nullopt;
  WrittenTable list;
  list.name = "fields.pvd";
  list.all.add(list_head);
  for (const auto &entry : entries)
  {
    list.without_last_row = list.all;
    list.all.add(line_of_list(entry));
  }
  list.last_time = entries.back().first;
  return list;
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
