"""Many runs by one program that has loaded its libraries: `continua --serve`."""

import concurrent.futures
import os
import socket
import subprocess
import tempfile
import time

from .errors import ProgramNotFound, RunFailed
from .program import command_of, environment, executable_of, message_of
from .results import Results


class Stopped(Exception):
    """The runs were ended."""


class Server:
    """A program that performs command lines, each in a copy of itself; a `with` block ends it.

    program   path of the program; None: `find_program()`
    """

    def __init__(self, program=None):
        self._program = executable_of(program)
        self._folder = tempfile.TemporaryDirectory(prefix="continua-")  # pylint: disable=consider-using-with
        self._socket = os.path.join(self._folder.name, "socket")
        self._screen = os.path.join(self._folder.name, "screen")
        self._is_stopped = False
        with open(self._screen, "w", encoding="utf-8") as screen:
            self._process = subprocess.Popen(  # pylint: disable=consider-using-with
                [self._program, "--serve", self._socket], env=environment(), stdin=subprocess.DEVNULL, stdout=screen,
                stderr=subprocess.STDOUT, start_new_session=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
        self._folder.cleanup()

    def stop(self):
        """Ends the program. Its commands get SIGTERM: a run ends after its present step, with a checkpoint."""
        self._is_stopped = True
        self._process.terminate()
        self._process.wait()

    def perform(self, command, screen):
        """Performs a command line, a list of texts without the name of the program; what it prints goes to the open file `screen`.
        Returns the exit status, or the number of the signal that ended it, negative. Who leaves before the end kills the command."""
        with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as connection, open(os.devnull, "rb") as nothing:
            self._connect(connection)
            arguments = [self._program, *command]
            texts = [os.getcwd(), str(len(arguments)), *arguments, *(f"{name}={value}" for name, value in environment().items())]
            message = b"".join(os.fsencode(text) + b"\0" for text in texts)
            socket.send_fds(connection, [message], [nothing.fileno(), screen.fileno(), screen.fileno()])
            while True:
                answer = connection.recv(4096).decode(errors="replace")
                if answer.startswith("ended "):
                    return int(answer.split()[1])
                if self._is_stopped:
                    raise Stopped()
                if answer != "started":
                    raise ProgramNotFound(f"{self._program} --serve performs nothing: {answer or 'it has ended'}")

    def _connect(self, connection):
        """Waits for the socket: the program loads its libraries first."""
        while True:
            try:
                return connection.connect(self._socket)
            except OSError:
                if self._is_stopped:
                    raise Stopped() from None
                if self._process.poll() is not None:
                    with open(self._screen, encoding="utf-8", errors="replace") as screen:
                        raise ProgramNotFound(f"{self._program} --serve has ended: {screen.read().strip()}") from None
                time.sleep(0.01)


def run_many(runs, jobs=1, program=None, keep_failures=False):
    """Performs many runs on one rank each, by one program that has loaded its libraries: a further run starts in some hundredths of a
    second instead of half a second. Returns the list of their `Results`.

    runs            a list; each of its parts is a dictionary of arguments of `run`: parameter_file, sets, output, overwrite, restart
    jobs            so many runs at the same time
    program         path of the program; None: `find_program()`
    keep_failures   True: the list has the `RunFailed` of a run that failed in its place; False: once all runs have ended, the first one
                    is raised

    Raises ValueError before any run if one has another argument or if two have one folder of results, ProgramNotFound, and RunFailed. An interruption from the
    keyboard ends each run after its present step, with a checkpoint, and no further one begins.
    """
    if jobs < 1 or jobs != int(jobs):
        raise ValueError(f"jobs is {jobs!r}; it needs a whole number from 1 on")
    for arguments in runs:
        unknown = set(arguments) - {"parameter_file", "sets", "output", "overwrite", "restart"}
        if unknown or "parameter_file" not in arguments:
            raise ValueError(f"a run is {dict(arguments)!r}; it needs a parameter_file, and may have sets, output, overwrite and restart")
    commands = [command_of(**arguments) for arguments in runs]
    folders = [os.path.realpath(output) for _, output in commands]
    for folder in folders:
        if folders.count(folder) > 1:
            raise ValueError(f"two runs have the folder {folder}; give each an output of its own")
    with Server(program) as server:

        def perform(command, output):
            with tempfile.TemporaryFile() as screen:
                status = server.perform(command, screen)
                if status == 0:
                    return Results(output)
                screen.seek(0)
                text = screen.read().decode(errors="replace")
                return RunFailed(status, message_of(status, text), [server._program, *command], text, output)

        with concurrent.futures.ThreadPoolExecutor(int(jobs)) as threads:
            try:
                results = list(threads.map(lambda run: perform(*run), commands))
            except BaseException:
                server.stop()
                raise
    for result in results:
        if isinstance(result, RunFailed) and not keep_failures:
            raise result
    return results
