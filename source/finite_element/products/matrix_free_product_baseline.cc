// As deal.II's package is compiled: one cell at a time.
#include <continua/finite_element/products/matrix_free_convection.templates.h>
#include <continua/finite_element/products/matrix_free_product.templates.h>

CONTINUA_DEFINE_MATRIX_FREE_PRODUCT(matrix_free_product_baseline, 1)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_baseline, 2, double)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_baseline, 2, float)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_baseline, 3, double)
CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_baseline, 3, float)
CONTINUA_DEFINE_MATRIX_FREE_CONVECTION(matrix_free_convection_baseline, 1)
CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(matrix_free_convection_baseline, 2)
CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(matrix_free_convection_baseline, 3)
