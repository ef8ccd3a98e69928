"""The version of Continua that this package belongs to."""

import os

_HERE = os.path.dirname(os.path.realpath(__file__))


def _read():
    # An installed package has the file beside it; in a checkout it is at the top.
    for folder in (_HERE, os.path.join(_HERE, "..", "..")):
        path = os.path.join(folder, "VERSION")
        if os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                return stream.readline().strip()
    raise ImportError(f"the package continua in {_HERE} is not complete: the file VERSION is missing. Install Continua again, or use "
                      "the folder python of a whole checkout.")


version = _read()
