# The Debian 12 packages that Epafi needs, and how to get them.  Sourced by ./run and ./check.
#
#   installPackages <group>...   installs what is missing of the groups: build, check, site, all

packagesOf() {
  case $1 in
    build)
      # Debian's Trilinos configurations include those of everything they were built on, but
      # their -dev packages do not depend on each other: hence the long list of trilinos.
      echo g++ cmake ninja-build
      echo libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libopenblas-dev
      echo libboost-dev libboost-math-dev libcgal-dev libcli11-dev libmuparser-dev libyaml-cpp-dev libptscotch-dev libscotch-dev
      echo libtrilinos-{teuchos,kokkos,kokkos-kernels,tpetra,belos,thyra,stratimikos,nox}-dev
      echo libtrilinos-{rtop,epetra,epetraext,triutils,xpetra,aztecoo,amesos,amesos2}-dev
      echo libtrilinos-{anasazi,galeri,ifpack,ifpack2,isorropia,ml,shylu,teko}-dev
      echo libtrilinos-{zoltan,zoltan2,trilinosss}-dev
      echo python3 python3-h5py python3-matplotlib  # epafi plot; the build's descriptions
      ;;
    check)
      echo clang-format-14 libxml2-utils python3-jsonschema flake8 mypy
      echo python3-pip python3-setuptools python3-wheel python3-pandas  # of the Python front
      echo mkdocs libjs-jquery  # the pages as a site, to follow their links
      ;;
    site) echo mkdocs doxygen libjs-jquery ;;  # with the headers: ninja -C build site
    all)
      echo clang-tidy-14 clang-14 libclang-rt-14-dev libomp-14-dev valgrind g++-aarch64-linux-gnu
      echo chromium  # opens reports
      echo python3-nbclient python3-nbformat python3-ipykernel  # execute the notebook
      ;;
  esac
}

# The packages among the arguments that are not installed, in one question to dpkg.
missingPackages() {
  local installed name
  installed=" $(dpkg-query -W -f='${db:Status-Status}:${Package} ' "$@" 2>/dev/null)"
  for name in "$@"; do
    [[ $installed == *" installed:$name "* ]] || echo "$name"
  done
}

installPackages() {
  local group needed=() missing
  for group in "$@"; do
    needed+=($(packagesOf "$group"))
  done
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "epafi: no apt-get here (Debian 12 is what is supported); not installing anything"
    return 0
  fi
  missing=($(missingPackages "${needed[@]}"))
  ((${#missing[@]} == 0)) && return 0

  local line="apt-get install -y --no-install-recommends ${missing[*]}"
  if ((EUID != 0)); then
    echo "epafi: ${#missing[@]} Debian packages are missing; as root, please run" >&2
    echo "    apt-get update && $line" >&2
    return 1
  fi
  echo "epafi: installing ${#missing[@]} missing Debian packages: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  # An update that fails need not matter: what is missing may be in the lists that are there.
  apt-get -q -o DPkg::Lock::Timeout=600 update || echo "epafi: apt-get update failed, going on"
  apt-get -q -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 install -y \
    --no-install-recommends "${missing[@]}" && return 0
  echo "epafi: apt-get failed (see above); what was tried: $line" >&2
  return 1
}
