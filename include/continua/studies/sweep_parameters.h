#ifndef continua_studies_sweep_parameters_h
#define continua_studies_sweep_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/studies/study_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Sweep: entries of the file, each with the values that it takes in the runs.
/// `analysis` is "automatic" or the name of any analysis: who reads the section knows them.
struct SweepParameters : StudyParameters
{
  /// One entry and its values.
  struct Axis
  {
    std::string path;                ///< "Materials/wall/Young's modulus"
    std::vector<std::string> values; ///< as texts for the entry, at least one, all different
    std::string naming_file;         ///< where they stand; ParameterText::command_line
  };
  std::vector<Axis> axes;          ///< none where the command line alone says what is swept
  bool is_grid = true;             ///< every value with every other; else the first with the first
  unsigned int asked_parallel = 0; ///< runs at a time; 0: as many as there are cores

  /// Declares and reads; throws InputError.
  void read(ParameterSection root);

  unsigned int n_runs() const;
  /// The number of the value of each axis in a run. On a grid the last axis changes first.
  std::vector<unsigned int> places(unsigned int run) const;
  /// What the entry is called in the names of the runs: its key, with as many of its sections as
  /// tell it from the others.
  std::string key(unsigned int axis) const;
  /// "young's modulus 2 MPa, wall thickness 1 mm".
  std::string name(unsigned int run) const;
};
} // namespace Continua

#endif
