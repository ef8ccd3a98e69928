"""Puts the file VERSION of the checkout beside the package, where an installed one looks for it."""

import os
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithVersion(build_py):
    def run(self):
        super().run()
        shutil.copy(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "VERSION"), os.path.join(self.build_lib, "continua"))


setup(cmdclass={"build_py": BuildWithVersion})
