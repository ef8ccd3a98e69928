#ifndef continua_materials_compression_h
#define continua_materials_compression_h

#include <limits>
#include <vector>

namespace Continua
{
/// One spring of the pressure that relaxes: p_k = -K_k e_k, de_k/dt = div U - e_k / tau_k. An
/// infinite tau makes it an elastic one and e the dilatation.
struct BulkBranch
{
  double bulk_modulus = 0.;                                         ///< K [Pa]
  double relaxation_time = std::numeric_limits<double>::infinity(); ///< tau [s]
};

/// How the pressure of a material follows its change of volume.
class Compression
{
public:
  enum class Kind
  {
    incompressible, ///< the volume cannot change
    elastic,        ///< by a bulk modulus K
    relaxing        ///< by bulk branches, side by side
  };

  /// Incompressible.
  Compression() = default;
  /// By 1/K [1/Pa]; a value of 0 gives an incompressible material.
  static Compression elastic(double inverse_bulk_modulus);
  /// By branches, at least one.
  static Compression relaxing(const std::vector<BulkBranch> &branches);

  Kind kind() const { return kind_of_compression; }
  bool is_incompressible() const { return kind_of_compression == Kind::incompressible; }
  /// Whether a bulk branch forgets.
  bool relaxes() const;
  /// 1/K [1/Pa]: 0 of an incompressible material; of bulk branches K is the instantaneous modulus,
  /// the sum over all of them.
  double inverse_bulk_modulus() const { return inverse_modulus; }
  /// 1/sum of the bulk moduli that never relax [1/Pa]; infinite if there are bulk branches and all
  /// of them relax.
  double long_term_inverse_bulk_modulus() const;
  /// Empty unless the kind is relaxing.
  const std::vector<BulkBranch> &bulk_branches() const { return branches; }

private:
  Kind kind_of_compression = Kind::incompressible;
  double inverse_modulus = 0.; ///< [1/Pa]
  std::vector<BulkBranch> branches;
};
} // namespace Continua

#endif
