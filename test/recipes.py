"""Do the recipes of Debian and Spack name what a build needs?  python3 recipes.py ROOT

Every package of the group `build` of cmake/packages.sh is in Build-Depends of debian/control (but
the compiler, which Debian forbids to list), its libraries in Depends of libepafi-dev, and nothing
is left to be filled in.  Every find_package of cmake/Dependencies.cmake and every library of that
group is a depends_on of the Spack recipe, of Trilinos as a variant.  The test of Spack's recipe
also tries itself on recipes that lack one.
"""
import ast
import os
import re
import subprocess
import sys

ROOT = sys.argv[1]
# Packages of Debian that are more than a name in Spack, and those that Debian alone needs:
# its Trilinos was configured with all of them, its -dev packages do not depend on each other.
SPACK = {"libopenmpi-dev": "mpi", "openmpi-bin": "mpi", "libhdf5-openmpi-dev": "hdf5+mpi",
         "libopenblas-dev": "openblas", "libboost-dev": "boost", "libboost-math-dev": "boost+math",
         "libcgal-dev": "cgal", "libcli11-dev": "cli11", "libmuparser-dev": "muparser",
         "libyaml-cpp-dev": "yaml-cpp"}
DEBIAN_ONLY = re.compile(r"lib(pt)?scotch-dev|libtrilinos-(rtop|epetra|epetraext|triutils|xpetra|aztecoo"
                         r"|amesos2?|anasazi|galeri|ifpack2?|isorropia|ml|shylu|teko|zoltan2?|trilinosss"
                         r"|teuchos|kokkos-kernels)-dev")
FOUND = {"OpenMP": "cxx", "LAPACK": "openblas", "MPI": "mpi", "HDF5": "hdf5"}


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as stream:
        return stream.read()


def needed():
    script = "source %s/cmake/packages.sh; packagesOf build" % ROOT
    return subprocess.check_output(["bash", "-c", script], text=True).split()


def field(paragraph, name):
    text = re.search(r"^%s:(.*(?:\n[ \t].*)*)" % name, paragraph, re.M)[1]
    return {re.split(r"[ (]", item.strip())[0] for item in text.split(",")}


def missing_in_debian(packages):
    control = subprocess.check_output(
        ["bash", os.path.join(ROOT, "cmake", "packaging", "debian.sh"), "--control"], text=True,
        env={**os.environ, "DEBEMAIL": "address"})
    paragraphs = {re.search(r"^(?:Source|Package): (.*)", part, re.M)[0]: part
                  for part in control.split("\n\n")}
    libraries = {name for name in packages if re.fullmatch("lib.*-dev", name)}
    wrong = (set(packages) - {"g++"}) ^ (field(paragraphs["Source: epafi"], "Build-Depends")
                                         - {"debhelper-compat", "dh-python"})
    wrong |= libraries - field(paragraphs["Package: libepafi-dev"], "Depends")
    return sorted(wrong | set(re.findall("@[A-Z]+@", control)))


def missing_in_spack(recipe, packages):
    has = {}  # name: variants
    for call in ast.walk(ast.parse(recipe)):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "depends_on":
            name, *variants = re.split(r"\+", re.sub(r"@[\w.:]*| .*", "", call.args[0].value))
            has[name] = set(variants)
    wants = set()
    for name in packages:
        trilinos = re.fullmatch(r"libtrilinos-(.*)-dev", name)
        if DEBIAN_ONLY.fullmatch(name) or not re.fullmatch(r"lib.*|openmpi.*", name):
            continue
        wants.add("trilinos+" + trilinos[1] if trilinos else SPACK.get(name, name))
    for name in re.findall(r"find_package\((\S+)", read("cmake", "Dependencies.cmake")):
        wants.add(FOUND.get(name, name.lower()))
    return sorted(want for want in wants
                  if want.split("+")[0] not in has
                  or not set(want.split("+")[1:]) <= has[want.split("+")[0]])


packages = needed()
recipe = read("cmake", "packaging", "spack", "package.py")
version = re.search(r"project\(Epafi VERSION (\S+)", read("CMakeLists.txt"))[1]
complaints = ["debian/control: " + name for name in missing_in_debian(packages)]
complaints += ["package.py: " + name for name in missing_in_spack(recipe, packages)]
for file, words in ((("cmake", "packaging", "spack", "package.py"), 'version("%s")'),
                    (("python", "pyproject.toml"), '\nversion = "%s"\n'),
                    (("CITATION.cff",), "\nversion: %s\n")):
    if words % version not in read(*file):
        complaints.append("%s: version %s" % (file[-1], version))
for line in re.findall(r".*depends_on\(.*\n", recipe):
    if not re.search(r'"(c|cmake@.*)"', line) and not missing_in_spack(recipe.replace(line, ""), packages):
        complaints.append("this test does not miss " + line.strip())
if not missing_in_spack(recipe.replace("+nox", ""), packages):
    complaints.append("this test does not miss +nox")
print("\n".join(complaints) or "%d packages are named" % len(packages))
sys.exit(len(complaints) > 0)
