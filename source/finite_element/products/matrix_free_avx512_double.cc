// Eight cells at a time in double precision, in three dimensions: in two, direct solvers serve.
#include <deal.II/base/config.h>
#undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512

#include <continua/finite_element/products/matrix_free_wide.templates.h>

CONTINUA_DEFINE_MATRIX_FREE_PRODUCT(matrix_free_product_avx512, 8)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_avx512, 3, double)
CONTINUA_DEFINE_MATRIX_FREE_CONVECTION(matrix_free_convection_avx512, 8)
CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(matrix_free_convection_avx512, 3)
CONTINUA_DEFINE_MATRIX_FREE_MESH(matrix_free_mesh_avx512, 8)
CONTINUA_INSTANTIATE_MATRIX_FREE_MESH(matrix_free_mesh_avx512, 3)
