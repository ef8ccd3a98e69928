#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>

#include <cmath>
#include <cstdlib>
#include <istream>
#include <map>
#include <utility>

namespace Continua
{
namespace
{
/// Reads line by line and knows where it is.
class Reader
{
public:
  Reader(std::istream &stream, const std::string &name) : stream(stream), origin{name, 0} {}

  /// Goes to the next line that is not empty; false at the end of the file.
  bool next()
  {
    while (std::getline(stream, text))
    {
      ++origin.line;
      const std::size_t end = text.find_last_not_of(" \t\r");
      if (end != std::string::npos)
      {
        text.resize(end + 1);
        return true;
      }
    }
    return false;
  }

  /// The numbers of the next line, at least `n_least` of them.
  std::vector<double> numbers(const std::size_t n_least)
  {
    if (!next())
      refuse_as_damaged("the file ends in the middle");
    std::vector<double> values;
    const char *rest = text.c_str();
    while (*rest != '\0')
    {
      char *end = nullptr;
      values.push_back(std::strtod(rest, &end));
      if (end == rest || !std::isfinite(values.back()))
        refuse_as_damaged("'" + text + "' should be a line of numbers");
      rest = end;
    }
    if (values.size() < n_least)
      refuse_as_damaged("'" + text + "' should have " + std::to_string(n_least) + " numbers");
    return values;
  }

  [[noreturn]] void refuse(const std::string &problem, const std::string &remedy) const
  {
    throw InputError(origin, "Geometry/File", problem, remedy);
  }

  [[noreturn]] void refuse_as_damaged(const std::string &problem) const
  {
    refuse(problem, "Write the file with gmsh again");
  }

  const std::string &line() const { return text; }
  unsigned int number() const { return origin.line; }

private:
  std::istream &stream;
  std::string text;
  Origin origin;
};

const std::string how_to_write = "Write it anew: gmsh FILE -save -format msh41 -o NEW.msh";

void read_format(Reader &reader)
{
  if (!reader.next() || reader.line() != "$MeshFormat")
    reader.refuse("this is no mesh file of gmsh, which begins with $MeshFormat",
                  "Write one: gmsh FILE.geo -2 -format msh41 (-3 for three dimensions)");
  const std::vector<double> values = reader.numbers(2);
  if (std::abs(values[0] - 4.1) > 1e-6)
    reader.refuse("the mesh has the format '" + reader.line() + "', not MSH 4.1", how_to_write);
  if (values[1] != 0.)
    reader.refuse("the mesh is written in binary, not in ASCII", how_to_write);
}

std::vector<GmshFile::Group> read_names(Reader &reader)
{
  std::vector<GmshFile::Group> groups;
  const double n_groups = reader.numbers(1)[0];
  for (unsigned int i = 0; i < n_groups; ++i)
  {
    if (!reader.next())
      reader.refuse_as_damaged("the file ends in the middle");
    // DIMENSION TAG "NAME"
    const std::string &line = reader.line();
    char *rest = nullptr;
    GmshFile::Group group;
    group.dimension = std::strtoul(line.c_str(), &rest, 10);
    group.tag = std::strtol(rest, &rest, 10);
    group.line = reader.number();
    const std::size_t begin = line.find('"');
    if (begin == std::string::npos || line.back() != '"' || line.size() < begin + 2)
      reader.refuse_as_damaged("'" + line + "' should be the name of a physical group");
    group.name = line.substr(begin + 1, line.size() - begin - 2);
    groups.push_back(group);
  }
  return groups;
}

/// Dimension and tag of a geometrical entity.
using Entity = std::pair<unsigned int, int>;

/// The tags of the physical groups of each entity.
std::map<Entity, std::vector<int>> read_entities(Reader &reader)
{
  std::map<Entity, std::vector<int>> groups;
  const std::vector<double> n_entities = reader.numbers(4);
  for (unsigned int dimension = 0; dimension < 4; ++dimension)
    for (unsigned int i = 0; i < n_entities[dimension]; ++i)
    {
      // TAG, a point's place or the corners of a bounding box, NUMBER OF GROUPS, GROUPS, ...
      const std::size_t place = dimension == 0 ? 4 : 7;
      const std::vector<double> values = reader.numbers(place + 1);
      if (values[place] < 0. || values.size() < place + 1 + values[place])
        reader.refuse_as_damaged("the line of an entity is too short");
      std::vector<int> &tags = groups[{dimension, static_cast<int>(values[0])}];
      // A minus sign turns the entity's orientation round, which a mesh has no use for.
      for (unsigned int j = 0; j < values[place]; ++j)
        tags.push_back(std::abs(static_cast<int>(values[place + 1 + j])));
    }
  return groups;
}

/// The points, and the place of each by its tag.
std::map<std::size_t, unsigned int> read_points(Reader &reader,
                                                std::vector<dealii::Point<3>> &points)
{
  std::map<std::size_t, unsigned int> places;
  const double n_blocks = reader.numbers(4)[0];
  for (unsigned int block = 0; block < n_blocks; ++block)
  {
    const double n_points = reader.numbers(4)[3];
    for (unsigned int i = 0; i < n_points; ++i)
      places[static_cast<std::size_t>(reader.numbers(1)[0])] = points.size() + i;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const std::vector<double> values = reader.numbers(3);
      points.emplace_back(values[0], values[1], values[2]);
    }
  }
  return places;
}

std::vector<GmshFile::Block> read_blocks(Reader &reader,
                                         const std::map<Entity, std::vector<int>> &groups,
                                         const std::map<std::size_t, unsigned int> &places)
{
  std::vector<GmshFile::Block> blocks;
  const double n_blocks = reader.numbers(4)[0];
  for (unsigned int i = 0; i < n_blocks; ++i)
  {
    const std::vector<double> header = reader.numbers(4);
    GmshFile::Block block;
    block.dimension = static_cast<unsigned int>(header[0]);
    block.entity = static_cast<int>(header[1]);
    block.type = static_cast<unsigned int>(header[2]);
    block.line = reader.number();
    const auto entity = groups.find({block.dimension, block.entity});
    if (entity != groups.end())
      block.groups = entity->second;
    for (unsigned int j = 0; j < header[3]; ++j)
    {
      // TAG, TAGS OF THE VERTICES
      const std::vector<double> tags = reader.numbers(2);
      std::vector<unsigned int> vertices;
      for (std::size_t v = 1; v < tags.size(); ++v)
      {
        const auto place = places.find(static_cast<std::size_t>(tags[v]));
        if (place == places.end())
          reader.refuse_as_damaged("an element has a node that is not in the file");
        vertices.push_back(place->second);
      }
      block.elements.push_back(vertices);
    }
    blocks.push_back(block);
  }
  return blocks;
}
} // namespace

GmshFile GmshFile::read(std::istream &stream, const std::string &name)
{
  Reader reader(stream, name);
  read_format(reader);
  GmshFile file;
  std::map<Entity, std::vector<int>> entities;
  std::map<std::size_t, unsigned int> places;
  bool has_elements = false;
  while (reader.next())
  {
    if (reader.line() == "$PhysicalNames")
      file.groups = read_names(reader);
    else if (reader.line() == "$Entities")
      entities = read_entities(reader);
    else if (reader.line() == "$PartitionedEntities")
      reader.refuse("the mesh is partitioned", "Write it without partitions; Continua makes them");
    else if (reader.line() == "$Nodes")
      places = read_points(reader, file.points);
    else if (reader.line() == "$Elements")
    {
      file.blocks = read_blocks(reader, entities, places);
      has_elements = true;
    }
    // Other sections (periodicity, results, ...) are none of ours.
  }
  if (!has_elements)
    reader.refuse("the file has no $Elements", "Mesh the geometry before writing the file");
  return file;
}
} // namespace Continua
