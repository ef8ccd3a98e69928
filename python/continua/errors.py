"""What can go wrong, and the warnings."""


class ContinuaError(Exception):
    """Any error of this package; its text says what is wrong and what to do."""


class ContinuaWarning(UserWarning):
    """Something was left out, or may be read wrongly; the text says what."""


class ResultsError(ContinuaError):
    """Results cannot be read.

    path      the file or folder, with ":LINE" if a line is at fault
    problem   what is wrong
    remedy    what to do; may be empty
    """

    def __init__(self, path, problem, remedy=""):
        super().__init__(path, problem, remedy)  # as they are, so that the error can be pickled
        self.path, self.problem, self.remedy = str(path), problem, remedy

    def __str__(self):
        return f"{self.path}: {self.problem}." + (f" {self.remedy}." if self.remedy else "")


class ProgramNotFound(ContinuaError):
    """There is no program of Continua to run."""


class RunFailed(ContinuaError):
    """A run ended with another exit status than 0.

    status    exit status: 1 for a run that failed or was interrupted, 2 for a wrong input; minus the number of a signal that ended
              the program
    message   what the program says of it
    command   list of the program and its arguments
    text      all that the run printed
    output    folder of the results; it need not exist
    """

    def __init__(self, status, message, command, text, output):
        super().__init__(status, message, command, text, output)
        self.status, self.message, self.command, self.text, self.output = status, message, command, text, output

    def __str__(self):
        return f"{self.message} (exit status {self.status})"
