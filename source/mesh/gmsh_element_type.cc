#include <continua/mesh/gmsh_element_type.h>

#include <map>

namespace Continua
{
GmshElementType GmshElementType::of(const unsigned int number)
{
  static const std::map<unsigned int, GmshElementType> table = {{1, {Shape::line, 2, 1}},
                                                                {8, {Shape::line, 3, 2}},
                                                                {26, {Shape::line, 4, 3}},
                                                                {27, {Shape::line, 5, 4}},
                                                                {28, {Shape::line, 6, 5}},
                                                                {2, {Shape::triangle, 3, 1}},
                                                                {9, {Shape::triangle, 6, 2}},
                                                                {21, {Shape::triangle, 10, 3}},
                                                                {3, {Shape::quadrilateral, 4, 1}},
                                                                {10, {Shape::quadrilateral, 9, 2}},
                                                                {16, {Shape::quadrilateral, 8, 2}},
                                                                {36, {Shape::quadrilateral, 16, 3}},
                                                                {37, {Shape::quadrilateral, 25, 4}},
                                                                {38, {Shape::quadrilateral, 36, 5}},
                                                                {39, {Shape::quadrilateral, 12, 3}},
                                                                {40, {Shape::quadrilateral, 16, 4}},
                                                                {4, {Shape::tetrahedron, 4, 1}},
                                                                {11, {Shape::tetrahedron, 10, 2}},
                                                                {29, {Shape::tetrahedron, 20, 3}},
                                                                {5, {Shape::hexahedron, 8, 1}},
                                                                {12, {Shape::hexahedron, 27, 2}},
                                                                {17, {Shape::hexahedron, 20, 2}},
                                                                {92, {Shape::hexahedron, 64, 3}},
                                                                {93, {Shape::hexahedron, 125, 4}},
                                                                {6, {Shape::prism, 6, 1}},
                                                                {13, {Shape::prism, 18, 2}},
                                                                {18, {Shape::prism, 15, 2}},
                                                                {7, {Shape::pyramid, 5, 1}},
                                                                {14, {Shape::pyramid, 14, 2}},
                                                                {19, {Shape::pyramid, 13, 2}}};
  const auto found = table.find(number);
  return found == table.end() ? GmshElementType() : found->second;
}

template <>
const std::vector<std::vector<unsigned int>> &corners_of_gmsh_nodes<2>()
{
  static const std::vector<std::vector<unsigned int>> corners = {
      {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}};
  return corners;
}

template <>
const std::vector<std::vector<unsigned int>> &corners_of_gmsh_nodes<3>()
{
  static const std::vector<std::vector<unsigned int>> corners = {{0, 1},
                                                                 {0, 3},
                                                                 {0, 4},
                                                                 {1, 2},
                                                                 {1, 5},
                                                                 {2, 3},
                                                                 {2, 6},
                                                                 {3, 7},
                                                                 {4, 5},
                                                                 {4, 7},
                                                                 {5, 6},
                                                                 {6, 7},
                                                                 {0, 1, 2, 3},
                                                                 {0, 1, 4, 5},
                                                                 {0, 3, 4, 7},
                                                                 {1, 2, 5, 6},
                                                                 {2, 3, 6, 7},
                                                                 {4, 5, 6, 7},
                                                                 {0, 1, 2, 3, 4, 5, 6, 7}};
  return corners;
}
} // namespace Continua
