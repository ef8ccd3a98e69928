"""How a script ends: with a message in place of a traceback if a file cannot be read or written, and quietly if nobody reads what it
prints."""

import os
import sys


def run(main, *errors):
    """Calls main. An error of the kinds given, or of the operating system, is printed; the exit status is then 1."""
    try:
        main()
    except BrokenPipeError:
        drop_output()
    except (*errors, OSError) as error:
        sys.exit(f"error: {text_of(error)}")
    finally:
        try:
            sys.stdout.flush()
        except BrokenPipeError:
            drop_output()
        except OSError as error:
            drop_output()
            sys.exit(f"error: {text_of(error)}")


def drop_output():
    """The rest of the output has no reader (| head) or no room. What Python still keeps of it would fail again as the script ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def text_of(error):
    if not isinstance(error, OSError):
        return str(error)
    # Opening a file names it; a later failure, as of a full disk, does not.
    return f"{error.filename or 'cannot write'}: {error.strerror}"
