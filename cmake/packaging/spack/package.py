from spack.package import *


class Epafi(CMakePackage):
    """Frictional contact of elastic bodies in the plane by stabilised mixed hp boundary elements:
    a program, a Python module and C++ libraries.

    Of a repository of Spack's this file is packages/epafi/package.py. No release has an address
    yet: `spack develop --path TREE epafi@0.2.0` takes the sources from a clone. The build and
    `epafi plot` start /usr/bin/python3, `epafi plot` with its matplotlib and h5py."""

    license("BSD-3-Clause")

    version("0.2.0")

    generator("ninja")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.20:", type="build")

    depends_on("mpi")
    depends_on("hdf5@1.10:+mpi")
    depends_on("openblas")
    depends_on("boost@1.74:+math")
    depends_on("cgal@5.5:5")
    depends_on("cli11@2.1:")
    depends_on("muparser@2.3:")
    depends_on("yaml-cpp@0.7:")
    # Later versions put their libraries into namespaces of CMake.
    depends_on("trilinos@13.2+mpi+kokkos+tpetra+belos+thyra+stratimikos+nox cxxstd=17")
