"""Runs programs through a server that has loaded them already: a client of Continua's CommandServer.

The start of a program that is linked with deal.II takes half a second of processor time, a copy of a process that has started some
milliseconds. The environment variable CONTINUA_SERVERS names a folder for the sockets; without it nothing is served. The first command of a
program starts its server, which ends by itself when no command has come for a minute. A program that was built anew has another server.
"""

import array
import contextlib
import fcntl
import hashlib
import os
import socket
import subprocess
import tempfile
import time

LONGEST_START = 120.0  # [s], beside other work
LARGEST_MESSAGE = 150_000  # [bytes], what a socket takes at once


class ServerFailure(Exception):
    """The server did not perform the command."""


def _socket_name(folder, program):
    """A socket for the program as it is now."""
    status = os.stat(program)
    text = f"{os.path.realpath(program)} {status.st_ino} {status.st_size} {status.st_mtime_ns}"
    return os.path.join(folder, hashlib.sha256(text.encode()).hexdigest()[:16])


def _connect(name):
    """A connection to the socket, or None. A path may be longer than sockets allow, a descriptor of its folder is short."""
    folder = os.open(os.path.dirname(name), os.O_RDONLY | os.O_DIRECTORY)
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    try:
        connection.connect(f"/proc/self/fd/{folder}/{os.path.basename(name)}")
        return connection
    except OSError:
        connection.close()
        return None
    finally:
        os.close(folder)


def _start_server(program, name, environment):
    """Starts the server unless another client has, and connects."""
    with open(name + ".lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        connection = _connect(name)
        if connection:
            return connection
        with contextlib.suppress(FileNotFoundError):
            os.remove(name)
        with open(name + ".log", "ab") as log:
            # In a session of its own: it outlives the test that starts it.
            process = subprocess.Popen([program, "--serve", os.path.basename(name)], cwd=os.path.dirname(name), env=environment,
                                       stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
        end = time.monotonic() + LONGEST_START
        while time.monotonic() < end and process.poll() is None:
            connection = _connect(name)
            if connection:
                return connection
            time.sleep(0.01)
    with open(name + ".log", encoding="utf-8", errors="replace") as log:
        raise ServerFailure(f"{program} --serve did not start:\n{log.read()}")


def _report(user_time, system_time):
    """Tells tests/measured.c, which sees the processor time of its own children alone."""
    descriptor = os.environ.get("CONTINUA_SERVED_TIMES")
    if descriptor:
        os.write(int(descriptor), f"{user_time} {system_time}\n".encode())


def is_on(program):
    """Whether commands of this program are served."""
    return bool(os.environ.get("CONTINUA_SERVERS")) and os.path.basename(program).startswith(("continua", "unit_tests_"))


def run(command, folder, environment, stdout, stderr, time_limit):
    """Runs the command with its input from /dev/null and its output to the two files. Returns its exit status, as subprocess has it. Raises
    subprocess.TimeoutExpired, and ServerFailure."""
    program = os.path.abspath(command[0])
    servers = os.environ["CONTINUA_SERVERS"]
    os.makedirs(servers, exist_ok=True)
    name = _socket_name(servers, program)
    texts = [os.path.abspath(folder or "."), str(len(command)), program, *command[1:], *(f"{key}={value}" for key, value in environment.items())]
    message = b"".join(os.fsencode(text) + b"\0" for text in texts)
    if len(message) > LARGEST_MESSAGE:
        raise ServerFailure(f"a command of {len(message)} bytes is too long")
    end = time.monotonic() + time_limit
    for _ in range(3):
        with open(os.devnull, "rb") as nothing, (_connect(name) or _start_server(program, name, environment)) as connection:
            descriptors = array.array("i", [nothing.fileno(), stdout.fileno(), stderr.fileno()])
            try:
                connection.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, descriptors)])
                answer = connection.recv(1000).decode()
            except OSError:
                continue
            if not answer:  # it has just ended, since nothing had come for a while
                continue
            if answer != "started":
                raise ServerFailure(answer)
            try:
                connection.settimeout(max(0.01, end - time.monotonic()))
                answer = connection.recv(1000).decode()
            except (TimeoutError, socket.timeout) as error:
                raise subprocess.TimeoutExpired(command, time_limit) from error
            word, *numbers = answer.split() or ["nothing"]
            if word != "ended":
                raise ServerFailure(f"the server of {program} ended while it was performing a command (it said: {answer!r})")
            _report(*numbers[1:])
            return int(numbers[0])
    raise ServerFailure(f"no server of {program} answers")


def run_and_read(command, folder, environment, time_limit):
    """As run, but returns a subprocess.CompletedProcess with the texts."""
    with tempfile.TemporaryFile() as stdout, tempfile.TemporaryFile() as stderr:
        status = run(command, folder, environment, stdout, stderr, time_limit)
        texts = []
        for stream in (stdout, stderr):
            stream.seek(0)
            texts.append(stream.read().decode("utf-8", errors="replace").replace("\r\n", "\n"))
    return subprocess.CompletedProcess(command, status, *texts)
