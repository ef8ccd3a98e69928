#ifndef continua_finite_element_products_matrix_free_wide_templates_h
#define continua_finite_element_products_matrix_free_wide_templates_h

// For a file that is compiled for wide instructions. deal.II's package has neither the wide numbers
// switched on (the file has done so before it includes this one) nor what MatrixFree needs
// instantiated for them: that happens here.

// Quadratic elements and mappings are all that is asked for.
#define FE_EVAL_FACTORY_DEGREE_MAX 2

#include <continua/finite_element/products/matrix_free_convection.templates.h>
#include <continua/finite_element/products/matrix_free_mesh.templates.h>
#include <continua/finite_element/products/matrix_free_product.templates.h>

#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
// deal.II 9.4's next file has the same guard.
#undef dealii_matrix_free_evaluation_template_factory_templates_h
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>

#endif
