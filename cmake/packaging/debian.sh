#!/bin/bash
# Packages for Debian 12: epafi, libepafi-dev, epafi-doc, and their source package.
#
#   DEBEMAIL=you@host cmake/packaging/debian.sh FOLDER [option of dpkg-buildpackage]...
#   cmake/packaging/debian.sh --control          only print debian/control
#
# What git has at HEAD is copied to FOLDER/epafi-<version>, cmake/packaging/debian completed as its
# debian/, and built there; the packages are in FOLDER.  Who builds them is their maintainer:
# DEBEMAIL and DEBFULLNAME, as for all of Debian's tools.  Unit tests run, unless
# DEB_BUILD_OPTIONS=nocheck.  Wants dpkg-dev, debhelper, dh-python and the group `build`.
set -e
root=$(cd "$(dirname "$0")/../.." && pwd)
source "$root/cmake/packages.sh"

# What a package needs is what ./run installs; a C++ compiler is there wherever packages are built.
needed=$(packagesOf build | tr ' ' '\n' | grep -vx 'g++')
complete() {
  sed -e "s|@BUILD@|$(paste -sd, <<<"$needed" | sed 's/,/,\\n /g')|" \
    -e "s|@DEVELOPMENT@|$(grep '^lib.*-dev$' <<<"$needed" | paste -sd, | sed 's/,/,\\n /g')|" \
    -e "s|@MAINTAINER@|${DEBFULLNAME:-The Epafi authors} <$DEBEMAIL>|" \
    -e "s|@VERSION@|$version|" -e "s|@DATE@|$date|" "$1"
}
if [[ $1 == --control ]]; then
  complete "$root/cmake/packaging/debian/control"
  exit
fi
if [[ -z $1 || $1 == -* || -z $DEBEMAIL ]]; then
  echo "usage: DEBEMAIL=you@host cmake/packaging/debian.sh FOLDER [option of dpkg-buildpackage]..." >&2
  exit 1
fi

version=$(sed -n 's/^project(Epafi VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
date=$(git -C "$root" log -1 --format=%cD)
tree=$1/epafi-$version
shift
if [[ -e $tree ]]; then
  echo "debian.sh: $tree exists already" >&2
  exit 1
fi
mkdir -p "$tree"
git -C "$root" archive HEAD | tar -x -C "$tree"
cp -r "$root/cmake/packaging/debian" "$tree/debian"
for file in control changelog; do
  complete "$root/cmake/packaging/debian/$file" >"$tree/debian/$file"
done
cd "$tree"
exec dpkg-buildpackage -us -uc "$@"
