# Configuring and building.  Sourced by ./run and ./check, which set `root`.
#
#   build <folder> <build type> [<target>...]    configures once, then builds what is out of date

build() {
  local folder=$1 type=$2 options=() name
  shift 2
  # A folder that was configured for another place (the clone was moved) is configured afresh.
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    [[ -e $folder/CMakeCache.txt ]] && options+=(--fresh)
    rm -f "$folder/build.ninja"
  fi
  if [[ ! -e $folder/build.ninja ]]; then
    echo "epafi: configuring $type in $folder"
    command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    cmake "${options[@]}" -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$type" || return 1
  fi
  # Ninja knows within milliseconds whether there is something to do; say so only then.
  if [[ $(ninja -C "$folder" -n "$@" 2>/dev/null) != *"no work to do"* ]]; then
    echo "epafi: building in $folder"
    ninja -C "$folder" -j "$(nproc)" "$@" || {
      echo "epafi: the build in $folder failed (see above)" >&2
      return 1
    }
  fi
}
