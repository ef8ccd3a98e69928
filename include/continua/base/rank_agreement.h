#ifndef continua_base_rank_agreement_h
#define continua_base_rank_agreement_h

#include <mpi.h>

#include <exception>
#include <string>

namespace Continua
{
class ParameterFile;

/**
 * Errors of several ranks. What all ranks throw is one error. What one rank throws alone leaves the
 * others in a collective operation, where they would wait for ever: this rank ends them.
 *
 * One lives as long as the program has MPI. Without one there is nobody to agree with.
 */
class RankAgreement
{
public:
  /// Collective.
  explicit RankAgreement(MPI_Comm communicator);
  ~RankAgreement();
  RankAgreement(const RankAgreement &) = delete;
  RankAgreement &operator=(const RankAgreement &) = delete;

  /// For the handler of an exception, before objects with collective destructors die. Returns when
  /// all ranks have come here, each with its exception. If they do not come in time, prints `text`
  /// with the number of this rank and ends all ranks with exit status `status`.
  static void wait_for_all(const std::string &text, int status);
  /// The same; then rank 0 prints its text, and each other text that another rank has.
  static void print_error(const std::string &text, int status);

private:
  MPI_Comm communicator; ///< used for nothing else
};

/// The exit statuses of the program.
constexpr int exit_status_of_failure = 1, exit_status_of_wrong_input = 2;

/// What a user reads of an exception that ended a run.
std::string text_of_failure(const std::exception &error);

/// Throws InputError on all ranks if one of them reads another content of a file that was read
/// until now. Collective.
void require_same_input(const ParameterFile &file, MPI_Comm communicator);
} // namespace Continua

#endif
