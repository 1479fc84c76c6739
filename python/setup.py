"""Tells the installed package where the tree is that it came from: its program may be built there
later.  All else is in pyproject.toml."""
import os

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithTree(build_py):
    def run(self):
        super().run()
        tree = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
        with open(os.path.join(self.build_lib, "epafi", "tree"), "w") as stream:
            stream.write(tree)


setup(cmdclass={"build_py": BuildWithTree})
