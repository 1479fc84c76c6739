#!/bin/bash
# The steps of a release, which it prints and does not do, and what a release hands out.
#
#   cmake/release.sh                  prints the steps for the version in CMakeLists.txt
#   cmake/release.sh --assets FOLDER  a .deb and a wheel of the Python part from build/, without network
set -e
root=$(cd "$(dirname "$0")/.." && pwd)
version=$(sed -n 's/^project(Epafi VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")

if [[ $1 == --assets && -n $2 ]]; then
  mkdir -p "$2"
  folder=$(cd "$2" && pwd)
  (cd "$root/build" && cpack -B "$folder/cpack" >/dev/null)
  mv "$folder"/cpack/*.deb "$folder"
  rm -r "$folder/cpack"
  tree=$(mktemp -d)  # setuptools writes into the tree that it builds
  cp -r "$root/python" "$tree"
  /usr/bin/python3 -m pip wheel --quiet --no-index --no-deps --no-build-isolation --wheel-dir "$folder" "$tree/python"
  rm -r "$tree"
  ls -1 "$folder"
  exit
fi
if (($# > 0)); then
  sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed '/^set/d' >&2
  exit 1
fi
cat <<STEPS
Epafi $version.  Promised from one minor version to the next: scene keys, columns, exit codes, Python;
headers of C++ within a minor version only.

1. The number, alike in CMakeLists.txt, python/pyproject.toml, CITATION.cff (with date-released) and
   cmake/packaging/spack/package.py:     ctest --test-dir build -R packaging
2. CHANGELOG.md: "Unreleased" becomes "$version", with the date; a new, empty "Unreleased" above it.
3. All tests, on a clean clone:           ./check --all
4. What is handed out, once here:         cmake/release.sh --assets /tmp/epafi-$version
   into an empty Debian 12 (debootstrap): apt install ./epafi_${version}_*.deb && epafi run hertz.xml
                                          python3 -m venv --system-site-packages v && v/bin/pip install epafi-$version-py3-none-any.whl
   and the clone's own way there:         ./run
                                          podman build -t epafi:$version .
5. The tag:                               git tag -s v$version -m "Epafi $version" && git push origin v$version
   .github/workflows/release.yml builds the .deb and the wheel of it and drafts a release with them.
6. Read the draft, put the section of CHANGELOG.md into it, publish it.
7. The site:                              ninja -C build site
8. The next version in the four files of step 1.
STEPS
