// Four cells at a time in double precision, in three dimensions: in two, direct solvers serve.
#include <deal.II/base/config.h>
#undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 256

#include <continua/finite_element/products/matrix_free_wide.templates.h>

CONTINUA_DEFINE_MATRIX_FREE_PRODUCT(matrix_free_product_avx2, 4)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_avx2, 3, double)
CONTINUA_DEFINE_MATRIX_FREE_CONVECTION(matrix_free_convection_avx2, 4)
CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(matrix_free_convection_avx2, 3)
CONTINUA_DEFINE_MATRIX_FREE_MESH(matrix_free_mesh_avx2, 4)
CONTINUA_INSTANTIATE_MATRIX_FREE_MESH(matrix_free_mesh_avx2, 3)
