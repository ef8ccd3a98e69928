#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_file.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
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
  Reader(const std::string &whole, const std::string &name) : whole(whole), origin{name, 0} {}

  /// Goes to the next line that is not empty; false at the end of the file. A line ends with a line
  /// feed, a carriage return or both.
  bool next()
  {
    while (place < whole.size())
    {
      const std::size_t begin = place;
      place = std::min(whole.find_first_of("\r\n", begin), whole.size());
      text = whole.substr(begin, place - begin);
      place += whole.compare(place, 2, "\r\n") == 0 ? 2 : 1;
      ++origin.line;
      const std::size_t end = text.find_last_not_of(" \t");
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

  /// A number of the present line as a whole one, not smaller than `lower`.
  int whole_number(const double value, const int lower = 0) const
  {
    if (!(value >= lower && value <= std::numeric_limits<int>::max()) || value != std::floor(value))
      refuse_as_damaged("'" + text + "' should have whole numbers" +
                        (lower == 0 ? " that are not negative" : ""));
    return static_cast<int>(value);
  }

  /// The same of the tag of a node, of which there may be more.
  std::size_t node_tag(const double value) const
  {
    constexpr double largest = 9007199254740992.; // 2^53: beyond it a double skips whole numbers
    if (!(value >= 0. && value <= largest) || value != std::floor(value))
      refuse_as_damaged("'" + text + "' should have the tags of nodes, whole numbers");
    return static_cast<std::size_t>(value);
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
  const std::string &whole;
  std::size_t place = 0; ///< in it, of the next line
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
  const int n_groups = reader.whole_number(reader.numbers(1)[0]);
  for (int i = 0; i < n_groups; ++i)
  {
    if (!reader.next())
      reader.refuse_as_damaged("the file ends in the middle");
    // DIMENSION TAG "NAME"
    const std::string &line = reader.line();
    char *rest = nullptr;
    GmshFile::Group group;
    group.dimension = reader.whole_number(std::strtod(line.c_str(), &rest));
    group.tag = reader.whole_number(std::strtod(rest, &rest), std::numeric_limits<int>::min());
    group.line = reader.number();
    const std::size_t begin = line.find('"');
    if (begin == std::string::npos || line.back() != '"' || line.size() < begin + 2)
      reader.refuse_as_damaged("'" + line + "' should be the name of a physical group");
    group.name = line.substr(begin + 1, line.size() - begin - 2);
    if (const std::string problem = problem_of_text(group.name); !problem.empty())
      reader.refuse("the name of a physical group " + problem, "Write the name in plain UTF-8");
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
    for (int i = 0, n = reader.whole_number(n_entities[dimension]); i < n; ++i)
    {
      // TAG, a point's place or the corners of a bounding box, NUMBER OF GROUPS, GROUPS, ...
      const std::size_t place = dimension == 0 ? 4 : 7;
      const std::vector<double> values = reader.numbers(place + 1);
      constexpr int negative = -std::numeric_limits<int>::max();
      const std::size_t n_tags = reader.whole_number(values[place]);
      if (values.size() < place + 1 + n_tags)
        reader.refuse_as_damaged("the line of an entity is too short");
      std::vector<int> &tags = groups[{dimension, reader.whole_number(values[0], negative)}];
      // A minus sign turns the entity's orientation round, which a mesh has no use for.
      for (std::size_t j = 0; j < n_tags; ++j)
        tags.push_back(std::abs(reader.whole_number(values[place + 1 + j], negative)));
    }
  return groups;
}

/// The points, and the place of each by its tag.
std::map<std::size_t, unsigned int> read_points(Reader &reader,
                                                std::vector<dealii::Point<3>> &points)
{
  std::map<std::size_t, unsigned int> places;
  const int n_blocks = reader.whole_number(reader.numbers(4)[0]);
  for (int block = 0; block < n_blocks; ++block)
  {
    const int n_points = reader.whole_number(reader.numbers(4)[3]);
    for (int i = 0; i < n_points; ++i)
      places[reader.node_tag(reader.numbers(1)[0])] = points.size() + i;
    for (int i = 0; i < n_points; ++i)
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
  const int n_blocks = reader.whole_number(reader.numbers(4)[0]);
  for (int i = 0; i < n_blocks; ++i)
  {
    const std::vector<double> header = reader.numbers(4);
    GmshFile::Block block;
    block.dimension = reader.whole_number(header[0]);
    block.entity = reader.whole_number(header[1], std::numeric_limits<int>::min());
    block.type = reader.whole_number(header[2]);
    const int n_elements = reader.whole_number(header[3]);
    block.line = reader.number();
    const auto entity = groups.find({block.dimension, block.entity});
    if (entity != groups.end())
      block.groups = entity->second;
    for (int j = 0; j < n_elements; ++j)
    {
      // TAG, TAGS OF THE VERTICES
      const std::vector<double> tags = reader.numbers(2);
      std::vector<unsigned int> vertices;
      for (std::size_t v = 1; v < tags.size(); ++v)
      {
        const auto place = places.find(reader.node_tag(tags[v]));
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

GmshFile GmshFile::read(const std::string &text, const std::string &name)
{
  Reader reader(text, name);
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
