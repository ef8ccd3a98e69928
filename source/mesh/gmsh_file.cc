#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_file.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
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

  /// The same of the tag of a node or an element, of which there may be more.
  std::size_t mesh_tag(const double value) const
  {
    constexpr double largest = 9007199254740992.; // 2^53: beyond it a double skips whole numbers
    if (!(value >= 0. && value <= largest) || value != std::floor(value))
      refuse_as_damaged("'" + text + "' should have the tags of nodes and elements, whole numbers");
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

/// The versions of the format, which differ in the order of the numbers.
enum class Version
{
  v1,  ///< of before 2005: $NOD and $ELM
  v2,  ///< 2.0 to 2.2, which many programs write
  v40, ///< 4.0
  v41  ///< 4.1
};

Version read_format(Reader &reader)
{
  bool has_line = reader.next();
  if (has_line && reader.line() == "$Comments")
  {
    while (has_line && reader.line() != "$EndComments")
      has_line = reader.next();
    has_line = reader.next();
  }
  if (has_line && reader.line() == "$NOD")
    return Version::v1;
  if (reader.line() != "$MeshFormat")
    reader.refuse("this is no mesh file of gmsh, which begins with $MeshFormat",
                  "Write one: gmsh FILE.geo -2 -format msh41 (-3 for three dimensions)");
  const std::vector<double> values = reader.numbers(2);
  const auto is = [&values](const double version) { return std::abs(values[0] - version) < 1e-6; };
  const bool is_2 = is(2.) || is(2.1) || is(2.2);
  if (!is_2 && !is(4.) && !is(4.1))
    reader.refuse("the mesh has the format '" + reader.line() + "', not MSH 1, 2, 4.0 or 4.1",
                  "Write it anew with gmsh 4: gmsh FILE -save -save_all -format msh41 -o NEW.msh");
  if (values[1] != 0.)
    reader.refuse("the mesh is written in binary, not in ASCII",
                  "Write it anew: gmsh FILE -save -save_all -format msh41 -setnumber Mesh.Binary 0 "
                  "-o NEW.msh");
  return is_2 ? Version::v2 : is(4.) ? Version::v40 : Version::v41;
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
    // Some programs name groups of the dimension -1, which have no elements.
    const int dimension = reader.whole_number(std::strtod(line.c_str(), &rest), -1);
    group.dimension = std::max(dimension, 0);
    group.tag = reader.whole_number(std::strtod(rest, &rest), std::numeric_limits<int>::min());
    group.line = reader.number();
    const std::size_t begin = line.find('"');
    if (begin == std::string::npos || line.back() != '"' || line.size() < begin + 2)
      reader.refuse_as_damaged("'" + line + "' should be the name of a physical group");
    group.name = line.substr(begin + 1, line.size() - begin - 2);
    if (const std::string problem = problem_of_text(group.name); !problem.empty())
      reader.refuse("the name of a physical group " + problem, "Write the name in plain UTF-8");
    if (dimension >= 0)
      groups.push_back(group);
  }
  return groups;
}

/// Dimension and tag of a geometrical entity.
using Entity = std::pair<unsigned int, int>;
/// The tags of the physical groups of each entity.
using GroupsOfEntities = std::map<Entity, std::vector<int>>;

constexpr int negative = -std::numeric_limits<int>::max();

/// The tags of groups in the present line, of which `values[place]` is the number. A minus sign
/// turns the entity's orientation round, which a mesh has no use for.
std::vector<int>
read_groups(const Reader &reader, const std::vector<double> &values, const std::size_t place)
{
  if (values.size() <= place)
    reader.refuse_as_damaged("the line of an entity is too short");
  const std::size_t n_tags = reader.whole_number(values[place]);
  if (values.size() < place + 1 + n_tags)
    reader.refuse_as_damaged("the line of an entity is too short");
  std::vector<int> tags;
  for (std::size_t i = 0; i < n_tags; ++i)
    tags.push_back(std::abs(reader.whole_number(values[place + 1 + i], negative)));
  return tags;
}

void read_entities(Reader &reader, const Version version, GroupsOfEntities &groups)
{
  const std::vector<double> n_entities = reader.numbers(4);
  for (unsigned int dimension = 0; dimension < 4; ++dimension)
    for (int i = 0, n = reader.whole_number(n_entities[dimension]); i < n; ++i)
    {
      // TAG, a point's place or the corners of a bounding box, NUMBER OF GROUPS, GROUPS, ...
      const std::size_t place = dimension == 0 && version == Version::v41 ? 4 : 7;
      const std::vector<double> values = reader.numbers(place + 1);
      groups[{dimension, reader.whole_number(values[0], negative)}] =
          read_groups(reader, values, place);
    }
}

/// The pieces of entities that a partition has made; the elements are on them. Returns the tags of
/// the ghost entities, whose elements belong to another partition's file.
std::set<int>
read_partitioned_entities(Reader &reader, const Version version, GroupsOfEntities &groups)
{
  std::set<int> ghosts;
  reader.numbers(1); // number of partitions
  for (int i = 0, n = reader.whole_number(reader.numbers(1)[0]); i < n; ++i)
    ghosts.insert(reader.whole_number(reader.numbers(2)[0], negative)); // TAG PARTITION
  const std::vector<double> n_entities = reader.numbers(4);
  for (unsigned int dimension = 0; dimension < 4; ++dimension)
    for (int i = 0, n = reader.whole_number(n_entities[dimension]); i < n; ++i)
    {
      // TAG, DIMENSION AND TAG OF THE PARENT, NUMBER OF PARTITIONS, PARTITIONS, then as above
      const std::vector<double> values = reader.numbers(4);
      const std::size_t n_partitions = reader.whole_number(values[3]);
      const std::size_t place =
          4 + n_partitions + (dimension == 0 && version == Version::v41 ? 3 : 6);
      const std::vector<int> tags = read_groups(reader, values, place);
      // What lies between two partitions has the tags of the entity that it cuts.
      if (values[1] == dimension)
        groups[{dimension, reader.whole_number(values[0], negative)}] = tags;
    }
  return ghosts;
}

/// The place of each point by its tag.
using Places = std::map<std::size_t, unsigned int>;

void add_point(const std::vector<double> &values,
               const std::size_t first,
               std::vector<dealii::Point<3>> &points)
{
  points.emplace_back(values[first], values[first + 1], values[first + 2]);
}

/// The points, one a line: TAG X Y Z.
void read_lines_of_points(Reader &reader,
                          const int n_points,
                          std::vector<dealii::Point<3>> &points,
                          Places &places)
{
  for (int i = 0; i < n_points; ++i)
  {
    const std::vector<double> values = reader.numbers(4);
    places[reader.mesh_tag(values[0])] = points.size();
    add_point(values, 1, points);
  }
}

Places read_points(Reader &reader, const Version version, std::vector<dealii::Point<3>> &points)
{
  Places places;
  const bool has_blocks = version == Version::v40 || version == Version::v41;
  const int n = reader.whole_number(reader.numbers(version == Version::v41 ? 4 : 1)[0]);
  if (!has_blocks)
    read_lines_of_points(reader, n, points, places);
  for (int block = 0; has_blocks && block < n; ++block)
  {
    const int n_points = reader.whole_number(reader.numbers(4)[3]);
    if (version == Version::v40)
    {
      read_lines_of_points(reader, n_points, points, places);
      continue;
    }
    for (int i = 0; i < n_points; ++i)
      places[reader.mesh_tag(reader.numbers(1)[0])] = points.size() + i;
    for (int i = 0; i < n_points; ++i)
      add_point(reader.numbers(3), 0, points);
  }
  return places;
}

/// The element of the present line, whose tag is the first number; the tags of its nodes begin at
/// `first`.
GmshFile::Element read_element(const Reader &reader,
                               const std::vector<double> &tags,
                               const std::size_t first,
                               const Places &places)
{
  GmshFile::Element element;
  element.tag = reader.mesh_tag(tags[0]);
  for (std::size_t v = first; v < tags.size(); ++v)
  {
    const auto place = places.find(reader.mesh_tag(tags[v]));
    if (place == places.end())
      reader.refuse_as_damaged("an element has a node that is not in the file");
    element.nodes.push_back(place->second);
  }
  return element;
}

/// Elements by their entity: versions 4.0 and 4.1.
std::vector<GmshFile::Block> read_blocks(Reader &reader,
                                         const Version version,
                                         const GroupsOfEntities &groups,
                                         const std::set<int> &ghosts,
                                         const Places &places)
{
  std::vector<GmshFile::Block> blocks;
  const int n_blocks = reader.whole_number(reader.numbers(version == Version::v41 ? 4 : 2)[0]);
  const unsigned int place_of_entity = version == Version::v41 ? 1 : 0;
  for (int i = 0; i < n_blocks; ++i)
  {
    const std::vector<double> header = reader.numbers(4);
    GmshFile::Block block;
    block.dimension = reader.whole_number(header[1 - place_of_entity]);
    block.entity = reader.whole_number(header[place_of_entity], std::numeric_limits<int>::min());
    block.type = reader.whole_number(header[2]);
    const int n_elements = reader.whole_number(header[3]);
    block.line = reader.number();
    const auto entity = groups.find({block.dimension, block.entity});
    if (entity != groups.end())
      block.groups = entity->second;
    for (int j = 0; j < n_elements; ++j)
      // TAG, TAGS OF THE NODES
      block.elements.push_back(read_element(reader, reader.numbers(2), 1, places));
    // The tag of a ghost entity may be that of a declared entity of another dimension.
    if (entity != groups.end() || ghosts.count(block.entity) == 0)
      blocks.push_back(block);
  }
  return blocks;
}

/// The dimension of an element type (gmsh reference manual 4.8, section 9.1).
unsigned int dimension_of_type(const unsigned int type)
{
  static const std::set<unsigned int> points = {15}, lines = {1, 8, 26, 27, 28},
                                      surfaces = {2,  3,  9,  10, 16, 20, 21, 22, 23, 24,
                                                  25, 36, 37, 38, 39, 40, 41, 42, 43, 44};
  return points.count(type) > 0 ? 0 : lines.count(type) > 0 ? 1 : surfaces.count(type) > 0 ? 2 : 3;
}

/// Elements with their group and entity in each line: versions 1 and 2. Of an entity in two groups
/// the elements stand there twice.
std::vector<GmshFile::Block>
read_lines_of_elements(Reader &reader, const Version version, const Places &places)
{
  std::vector<GmshFile::Block> blocks;
  std::map<std::pair<Entity, std::vector<unsigned int>>, std::pair<std::size_t, std::size_t>> known;
  std::map<std::pair<Entity, std::pair<unsigned int, std::vector<int>>>, std::size_t> place_of;
  const auto block_of =
      [&](const Entity &entity, const unsigned int type, const std::vector<int> &groups)
  {
    const auto [place, is_new] =
        place_of.emplace(std::make_pair(entity, std::make_pair(type, groups)), blocks.size());
    if (is_new)
      blocks.push_back({entity.first, entity.second, type, groups, {}, reader.number()});
    return place->second;
  };
  for (int i = 0, n = reader.whole_number(reader.numbers(1)[0]); i < n; ++i)
  {
    // Version 1: TAG TYPE GROUP ENTITY NUMBER-OF-VERTICES VERTICES
    // Version 2: TAG TYPE NUMBER-OF-TAGS GROUP ENTITY ... VERTICES
    const std::vector<double> values = reader.numbers(version == Version::v1 ? 6 : 4);
    const unsigned int type = reader.whole_number(values[1]);
    const std::size_t n_tags = version == Version::v1 ? 2 : reader.whole_number(values[2]);
    const std::size_t tags = version == Version::v1 ? 2 : 3;
    const std::size_t first = version == Version::v1 ? 5 : 3 + n_tags;
    if (values.size() <= first)
      reader.refuse_as_damaged("the line of an element is too short");
    std::vector<int> groups;
    if (n_tags > 0)
      groups.push_back(std::abs(reader.whole_number(values[tags], negative)));
    if (!groups.empty() && groups.front() == 0)
      groups.clear(); // 0 stands for no group
    const Entity entity{dimension_of_type(type),
                        n_tags > 1 ? reader.whole_number(values[tags + 1], negative) : 0};
    GmshFile::Element element = read_element(reader, values, first, places);
    std::vector<unsigned int> ordered = element.nodes;
    std::sort(ordered.begin(), ordered.end());
    const auto [earlier, is_new] =
        known.emplace(std::make_pair(entity, ordered), std::make_pair(0, 0));
    if (!is_new)
    {
      auto &[block, place] = earlier->second;
      std::vector<int> all = blocks[block].groups;
      if (groups.empty() || std::find(all.begin(), all.end(), groups.front()) != all.end())
        continue; // the same element once more
      all.push_back(groups.front());
      element = blocks[block].elements[place];
      blocks[block].elements[place].nodes.clear();
      groups = all;
    }
    const std::size_t block = block_of(entity, type, groups);
    earlier->second = {block, blocks[block].elements.size()};
    blocks[block].elements.push_back(element);
  }
  for (GmshFile::Block &block : blocks)
    block.elements.erase(std::remove_if(block.elements.begin(), block.elements.end(),
                                        [](const auto &each) { return each.nodes.empty(); }),
                         block.elements.end());
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                              [](const auto &block) { return block.elements.empty(); }),
               blocks.end());
  return blocks;
}
} // namespace

GmshFile GmshFile::read(const std::string &text, const std::string &name)
{
  Reader reader(text, name);
  const Version version = read_format(reader);
  const bool has_entities = version == Version::v40 || version == Version::v41;
  GmshFile file;
  GroupsOfEntities entities;
  std::set<int> ghosts;
  Places places;
  bool has_elements = false;
  // Of version 1 the first section is open already.
  for (bool is_open = version == Version::v1; is_open || reader.next(); is_open = false)
  {
    const std::string &section = reader.line();
    if (section == "$PhysicalNames")
      file.groups = read_names(reader);
    else if (section == "$Entities" && has_entities)
      read_entities(reader, version, entities);
    else if (section == "$PartitionedEntities" && has_entities)
      ghosts = read_partitioned_entities(reader, version, entities);
    else if (section == "$Nodes" || section == "$NOD" || section == "$ParametricNodes")
      places = read_points(reader, version, file.points);
    else if (section == "$Elements" || section == "$ELM")
    {
      file.blocks = has_entities ? read_blocks(reader, version, entities, ghosts, places)
                                 : read_lines_of_elements(reader, version, places);
      has_elements = true;
    }
    // Other sections (periodicity, results, ...) are none of ours.
  }
  if (!has_elements)
    reader.refuse(
        "the file has no $Elements",
        "Mesh the geometry before writing the file. gmsh writes such a file also where it could "
        "not read its input; it says so on the screen");
  return file;
}
} // namespace Continua
