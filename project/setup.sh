# Set-up of the machine for ./sbt: finds what a command needs and, as root on Debian or Ubuntu, installs what is missing.
# Sourced by ./sbt; the only output on success is a line for each installation, on stderr.

# fail MESSAGE: the one line that tells what is missing.
fail() {
  echo "error: $1" >&2
  exit 2
}

# install PACKAGE...: by apt-get, or an exit that names the packages.
install() {
  command -v apt-get >/dev/null || fail "needs $*: install the package of that name and try again"
  [ "$(id -u)" = 0 ] || fail "needs $*: run 'apt-get install $*' as root and try again"
  echo "installing $* (log in .cache/setup.log)" >&2
  mkdir -p .cache
  {
    apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
  } >>.cache/setup.log 2>&1 </dev/null || fail "apt-get cannot install $*: see .cache/setup.log"
}

# need PROGRAM PACKAGE [PROGRAM PACKAGE]...: installs the packages of the programs that are not on PATH.
need() {
  local packages=()
  while [ $# -gt 0 ]; do
    command -v "$1" >/dev/null || packages+=("$2")
    shift 2
  done
  [ ${#packages[@]} = 0 ] || install "${packages[@]}"
}

# want PROBE PACKAGE...: for what a command can do without: installed when it costs the user nothing, else skipped.
want() {
  local probe=$1
  shift
  if ! eval "$probe" && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    (install "$@") || true
  fi
}

# launcher VERSION SHA256: puts sbt's launcher into .cache, by its Maven coordinates, and checks it.
launcher() {
  jar=.cache/sbt-launch-$1.jar
  if ! [ -e "$jar" ]; then
    need mvn maven
    mkdir -p .cache
    echo "fetching sbt $1" >&2
    mvn -q -B org.apache.maven.plugins:maven-dependency-plugin:3.6.1:copy \
      "-Dartifact=org.scala-sbt:sbt-launch:$1" -DoutputDirectory=.cache >>.cache/setup.log 2>&1 </dev/null ||
      fail "Maven cannot fetch org.scala-sbt:sbt-launch:$1: check the network, see .cache/setup.log"
  fi
  if ! echo "$2  $jar" | sha256sum --check --quiet >/dev/null 2>&1; then
    rm -f "$jar"
    fail "the checksum of org.scala-sbt:sbt-launch:$1 is wrong: it was removed, try again"
  fi
}

simulator() {
  need verilator verilator make make g++ g++
  # Waveforms in FST are compressed.
  want '[ -e /usr/include/zlib.h ]' zlib1g-dev
  # Half of compiling a model is Verilator's own sources again.
  want 'command -v ccache >/dev/null' ccache
}

# model_settings: the environment in which simulations are compiled.
model_settings() {
  # Verilator's makefiles compile for size, 20 % slower, unless they are told otherwise.
  export MAKEFLAGS="${MAKEFLAGS:+$MAKEFLAGS }OPT_FAST=-O2"
  export SPINAL_MAKE_CMD="${SPINAL_MAKE_CMD:-project/make-model}"
  if command -v ccache >/dev/null; then
    export OBJCACHE="${OBJCACHE-ccache}"
    # ccache does not compare headers as new as a model's, nor precompiled ones (newer Verilators'), unless told.
    export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS-include_file_mtime,include_file_ctime,pch_defines,time_macros}"
  fi
}

# test_parts: without them the tests that compare with Mesa and those that open a window are cancelled.
test_parts() {
  want 'ldconfig -p | grep -q libOSMesa' libosmesa6-dev
  want 'command -v Xvfb >/dev/null' xvfb
}

# python_venv: for the tools that come from PyPI.
python_venv() {
  python3 -c 'import ensurepip, venv' 2>/dev/null || install python3 python3-venv
}

# prepare COMMAND: what one command line of sbt needs beyond Java.
prepare() {
  case " $1 " in
    *" --help "*) ;;
    " bitstream "*)
      python_venv
      want 'command -v icetime >/dev/null && [ -e /usr/share/fpga-icestorm/chipdb/chipdb-5k.txt ]' \
        fpga-icestorm fpga-icestorm-chipdb
      ;;
    " play "*)
      # `play raster` draws by the model unless it is told otherwise.
      case " $1 " in
        *" --engine model "* | *" --engine reference "*) ;;
        " play raster "*) [[ $1 != *--engine* ]] || simulator ;;
        *) simulator ;;
      esac
      want '[ -z "${DISPLAY-}" ] || ls "$(dirname "$(readlink -f "$(command -v java)")")"/../lib/libawt_xawt.so >/dev/null 2>&1' default-jre
      ;;
    *" --engine model "* | *" --engine reference "*) ;;
    " fit "*)
      simulator
      [[ " $1 " == *" --no-synthesis "* ]] || python_venv
      want 'ldconfig -p | grep -q libOSMesa' libosmesa6-dev # a referee
      ;;
    " mutate "*)
      simulator
      python_venv
      ;;
    " chart "*" --no-synthesis "*) ;;
    " chart "*) python_venv ;;
    " demo "* | " render "* | " bench "* | " pong "* | " voxel "*) simulator ;;
    " quick ") test_parts ;;
    *test* | *Test*)
      simulator
      test_parts
      # Proofs: the solver; SymbiYosys comes with Yosys from PyPI, which needs venv.
      want 'command -v z3 >/dev/null' z3
      want "python3 -c 'import ensurepip, venv' 2>/dev/null" python3 python3-venv
      ;;
  esac
}

prepare_all() {
  need java default-jdk-headless # 17 in Debian 12, 21 in Debian 13
  local line
  for line in "$@"; do prepare "$line"; done
}
