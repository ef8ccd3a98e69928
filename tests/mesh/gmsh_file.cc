#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>

#include "../unit_test.h"
#include "gmsh_meshes.h"

#include <sstream>

namespace test_of_gmsh_file
{
using namespace Continua;
using meshes::squares;

namespace
{
GmshFile read(const std::string &text)
{
  return GmshFile::read(text, "x.msh");
}

void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { read(text); }, "^x.msh:" + pattern);
}
} // namespace

UNIT_TEST(gmsh_file)
{
  const GmshFile file = read(squares);
  check::absolute("groups", file.groups.size(), 6., 0.);
  check::equal("name with a blank", file.groups[2].name, "around it");
  check::is_true("group", file.groups[3].dimension == 2 && file.groups[3].tag == 7 &&
                              file.groups[3].line == 9);
  check::absolute("points", file.points.size(), 7., 0.);
  check::absolute("a coordinate", file.points[6][2], 3., 0.);
  check::absolute("blocks", file.blocks.size(), 7., 0.);
  const GmshFile::Block &block = file.blocks[2];
  check::is_true("block",
                 block.dimension == 1 && block.entity == 2 && block.type == 1 && block.line == 47);
  check::is_true("a group with a minus sign", block.groups == std::vector<int>{3});
  check::is_true("vertices", file.blocks[6].elements[0] == std::vector<unsigned int>({1, 4, 5, 2}));
  check::is_true("no group", file.blocks[4].groups.empty());

  std::string windows;
  for (const char character : squares)
    windows += character == '\n' ? std::string("\r\n") : std::string(1, character);
  check::equal("other ends of line, and an unknown section",
               read(meshes::with(windows, "$Nodes", "$Comments\r\na b\r\n$EndComments\r\n$Nodes"))
                   .groups[2]
                   .name,
               "around it");

  refused("empty", "", "0?.*no mesh file");
  refused("another file", "Point(1) = {0, 0, 0};\n", "1: 'Geometry/File'.*-format msh41");
  refused("version 2", meshes::with(squares, "4.1 0 8", "2.2 0 8"), "2:.*'2.2 0 8'.*-format msh41");
  refused("binary", meshes::with(squares, "4.1 0 8", "4.1 1 8"), "2:.*binary.*-format msh41");
  refused("no number", meshes::with(squares, "2 1 0\n", "2 l 0\n"), "38:.*'2 l 0'.*numbers");
  refused("too few numbers", meshes::with(squares, "2 1 0\n", "2 1\n"), "38:.*3 numbers");
  refused("cut off", squares.substr(0, squares.find("9 11 12 15 14")), "56:.*ends in the middle");
  refused("no elements", squares.substr(0, squares.find("$Elements")), "40:.*no .Elements");
  refused("unknown node", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 18"), "57:.*node");
  refused("broken name", meshes::with(squares, "\"fluid\"", "\"fluid"), "9:.*name");
  refused("no finite coordinate", meshes::with(squares, "2 1 0\n", "nan 1 0\n"), "38:.*nan");
  refused("infinite coordinate", meshes::with(squares, "2 1 0\n", "2 1e999 0\n"), "38:.*1e999");
  refused("tag too large", meshes::with(squares, "2 2 3 1\n", "2 1e300 3 1\n"),
          "58:.*whole numbers");
  refused("negative count", meshes::with(squares, "2 2 3 1\n", "2 2 3 -1\n"), "58:.*negative");
  refused("half a node", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 14.5"), "57:.*tags of");
  refused("node beyond all", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 1e300"),
          "57:.*tags of");
  refused("groups of an entity",
          meshes::with(squares, "2 1 0 0 2 0 0 1 -3 0", "2 1 0 0 2 0 0 1e9 3 0"), "17:.*too short");
  refused("group beyond all",
          meshes::with(squares, "2 1 0 0 2 0 0 1 -3 0", "2 1 0 0 2 0 0 1 -3e10 0"),
          "17:.*whole numbers");
  refused("escape in a name", meshes::with(squares, "\"fluid\"", "\"\x1b[2J\""),
          "9:.*control character 0x1b");
  refused("partitioned",
          meshes::with(squares, "$Nodes", "$PartitionedEntities\n$EndPartitionedEntities\n$Nodes"),
          "23:.*partition");
}
} // namespace test_of_gmsh_file
