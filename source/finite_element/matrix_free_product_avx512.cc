// Eight cells at a time in double precision. deal.II's package has neither the wide numbers
// switched on nor what MatrixFree needs instantiated for them: both happens here.
#include <deal.II/base/config.h>
#undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512
// Quadratic elements and mappings are all that is asked for.
#define FE_EVAL_FACTORY_DEGREE_MAX 2

#include <continua/finite_element/matrix_free_convection.templates.h>
#include <continua/finite_element/matrix_free_product.templates.h>

#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
// deal.II 9.4's next file has the same guard.
#undef dealii_matrix_free_evaluation_template_factory_templates_h
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>

CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(matrix_free_product_avx512, 8)
CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(matrix_free_convection_avx512, 8)
