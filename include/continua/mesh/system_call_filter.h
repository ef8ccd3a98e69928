#ifndef continua_mesh_system_call_filter_h
#define continua_mesh_system_call_filter_h

namespace Continua
{
/**
 * From now on the system refuses to the calling thread, and to the threads that it starts, to start
 * a program, to open a file for writing, to make, rename, remove or change files, to open a
 * connection, and to send signals to other processes; each such call fails with EPERM. For ever:
 * there is no way back. Other threads of the process are not touched. Throws std::runtime_error
 * where the system (Linux on x86-64 or ARM64 with seccomp is needed) does not know how.
 */
void refuse_programs_and_writing_to_this_thread();
} // namespace Continua

#endif
