"""Runs the program."""

import collections.abc
import os
import re
import shutil
import signal
import subprocess
import sys

from .errors import ProgramNotFound, RunFailed
from .results import Results

_HERE = os.path.dirname(os.path.realpath(__file__))


def find_program():
    """The path of the program: the environment variable CONTINUA_PROGRAM; build/release/continua of the checkout that this package is in,
    or bin/continua of where it is installed; `continua` of the PATH. Raises ProgramNotFound."""
    given = os.environ.get("CONTINUA_PROGRAM")
    if given:
        return _executable(given, "the environment variable CONTINUA_PROGRAM names it")
    if os.path.basename(os.path.dirname(_HERE)) == "python":
        build = os.environ.get("CONTINUA_BUILD_ROOT", os.path.join(_HERE, "..", "..", "build"))
        own = os.path.join(build, "release", "continua")
    else:  # PREFIX/lib/python3/dist-packages/continua
        own = os.path.join(_HERE, "..", "..", "..", "..", "bin", "continua")
    own = os.path.normpath(own)
    if os.access(own, os.X_OK) and os.path.isfile(own):
        return own
    found = shutil.which("continua")
    if found is None:
        raise ProgramNotFound(f"there is no program of Continua: {own} is missing, and no 'continua' is in the PATH. Build it with "
                              "scripts/quickstart, or name it by program=... or the environment variable CONTINUA_PROGRAM")
    return found


def executable_of(program):
    """The path of a program that is named, or of `find_program()` if it is None."""
    return find_program() if program is None else _executable(os.fspath(program), "program=... names it")


def _executable(path, why):
    if not (os.path.isfile(path) and os.access(path, os.X_OK)):
        raise ProgramNotFound(f"{path} is no program that can be run; {why}")
    return os.path.abspath(path)


def environment():
    """The environment of a run: as this process has it, but one thread a rank where nothing else is set, and Open MPI allows more ranks
    than cores, and root."""
    wanted = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1",
              "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
              "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe", "PRTE_MCA_hwloc_default_binding_policy": "none",
              "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return {**wanted, **os.environ}


def _value_text(key, value):
    """The value of an entry as a parameter file has it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(_value_text(key, part) for part in value)
    if isinstance(value, str):
        return value
    try:
        return repr(float(value)) if float(value) != int(value) else str(int(value))
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"sets: the value {value!r} of '{key}' is no text, number, bool or list of these") from None


def run(parameter_file, sets=None, output=None, program=None, ranks=1, overwrite=False, restart=False, progress=False):
    """Runs a parameter file and waits for its end. Returns the `Results`.

    sets        {"Section/Key": value}, as --set of the command line; a value is a text such as "2 GPa", a number, a bool or a list
    output      folder of the results; None: output/NAME in the working directory, for NAME.prm
    program     path of the program; None: `find_program()`
    ranks       number of MPI ranks
    overwrite   removes the results of an earlier run in the folder; without it, or restart, such a folder is an error
    restart     goes on from the last checkpoint in the folder
    progress    True prints what the run prints while it runs; a function is called with each line instead

    Raises RunFailed if the exit status is not 0, and ProgramNotFound. A value that misses its expected value is no failure: it is in
    `results.checks`. An interruption from the keyboard ends the run after its present step, with a checkpoint.
    """
    if ranks < 1 or ranks != int(ranks):
        raise ValueError(f"ranks is {ranks!r}; it needs a whole number from 1 on")
    arguments, output = command_of(parameter_file, sets, output, overwrite, restart)
    command = [executable_of(program), *arguments]
    if ranks > 1:
        command = ["mpiexec", "--bind-to", "none", "-n", str(ranks), *command]
    show = progress if callable(progress) else (lambda line: print(line, flush=True)) if progress else lambda line: None
    status, text = _perform(command, show)
    if status != 0:
        raise RunFailed(status, message_of(status, text), command, text, output)
    return Results(output)


def command_of(parameter_file, sets=None, output=None, overwrite=False, restart=False):
    """(the command line of a run without the name of the program, the folder of its results), as for `run`."""
    if sets is not None and not isinstance(sets, collections.abc.Mapping):
        raise TypeError(f"sets is a {type(sets).__name__}; it needs a dictionary such as {{\"Time/End time\": \"1 s\"}}")
    parameter_file = os.fspath(parameter_file)
    command = [parameter_file]
    for key, value in (sets or {}).items():
        command += ["--set", f"{key}={_value_text(key, value)}"]
    if output is None:
        output = os.path.join("output", os.path.splitext(os.path.basename(parameter_file))[0])
    output = os.fspath(output)
    return command + ["--output", output] + ["--overwrite"] * bool(overwrite) + ["--restart"] * bool(restart), output


def _perform(command, show):
    """(exit status, all that was printed)."""
    lines = []
    try:
        # A session of its own: what the keyboard sends comes from here alone, once.
        process = subprocess.Popen(command, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, errors="replace", start_new_session=True)
    except OSError as error:
        raise ProgramNotFound(f"{command[0]} cannot be run: {error.strerror}") from error
    try:
        for line in process.stdout:
            lines.append(line)
            show(line.rstrip("\n"))
    except BaseException:
        process.send_signal(signal.SIGINT)
        print("waiting for the end of the present step of the run", file=sys.stderr, flush=True)
        process.communicate()
        raise
    finally:
        process.stdout.close()
        process.wait()
    return process.returncode, "".join(lines)


def message_of(status, text):
    """What the program says of its end, without what MPI adds."""
    if status < 0:
        return f"the program was ended by the signal {signal.Signals(-status).name}"
    text = re.split(r"^-{20,}$", text, maxsplit=1, flags=re.MULTILINE)[0].strip()
    _, error, message = text.rpartition("error: ")
    message = message.strip() if error else "\n".join(text.splitlines()[-3:]) or "the program printed nothing"
    if "--overwrite" in message:
        message += " In Python these are overwrite=True, restart=True and output=..."
    return message
