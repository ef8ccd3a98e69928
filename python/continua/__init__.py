"""Continua from Python: run parameter files, and read what the runs wrote.

    import continua

    run = continua.run("parameter_files/thesis/chapter-4/beam.prm", sets={"Time/End time": "1 s"}, output="output/short")
    runs = continua.run_many([{"parameter_file": ..., "sets": ..., "output": ...}, ...], jobs=2)   # many short ones
    run = continua.open("output/short")                 # the same results, later
    run.probes["tip: displacement y"].plot()            # pandas, indexed by the time in s
    run.quantity("frequency", probe="tip")              # a number of the summary, in SI units

`open` and `run` return `Results`. Tables are pandas.DataFrame, waves are xarray.Dataset, a state of the fields is an xarray.Dataset
or a vtkUnstructuredGrid. All numbers are in SI units; a table has the units of its columns in `frame.attrs["units"]`.

Nothing is read before it is asked for, and pandas, xarray and VTK are imported when they are needed first.

Errors: `ResultsError` when results cannot be read, `RunFailed` when a run ends with another exit status than 0,
`ProgramNotFound` when there is no program to run; all of them are `ContinuaError`. `ContinuaWarning` is the category of warnings.
"""

from .errors import ContinuaError, ContinuaWarning, ProgramNotFound, ResultsError, RunFailed
from .program import find_program, run
from .results import Results
from .results import open_results as open  # pylint: disable=redefined-builtin
from .server import run_many
from .version import version as __version__

__all__ = ["ContinuaError", "ContinuaWarning", "ProgramNotFound", "Results", "ResultsError", "RunFailed", "find_program", "open", "run",
           "run_many", "__version__"]
