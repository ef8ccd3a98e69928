#include <continua/postprocess/run_table.h>

#include <continua/postprocess/writing_rank.h>

namespace Continua
{
void RunTable::open(const std::string &file, const std::vector<std::string> &header)
{
  on_writing_rank(communicator, [&]() { writer = std::make_unique<TableWriter>(file, header); });
}

void RunTable::resume(const std::string &file,
                      const std::vector<std::string> &header,
                      const double restart_time)
{
  on_writing_rank(communicator,
                  [&]() { writer = std::make_unique<TableWriter>(file, header, restart_time); });
}

void RunTable::row(const std::vector<double> &values)
{
  if (writer)
    writer->row(values);
}

void RunTable::flush()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (writer)
                      writer->flush();
                  });
}

void RunTable::flush_to_disk()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (writer)
                      writer->flush_to_disk();
                  });
}

std::optional<WrittenTable> RunTable::written() const
{
  return writer ? std::make_optional(writer->written()) : std::nullopt;
}
} // namespace Continua
