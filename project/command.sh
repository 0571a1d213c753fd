# Runs a command of the workbench, such as ./sbt "render --scene teapot", on its compiled classes and outside of
# sbt, so that exit code and stderr are the command's own. Sourced by ./sbt; `jar` is sbt's launcher.

# is_command WORDS...: one command line, or a command's name followed by its options as words of their own.
is_command() {
  local names
  names=" $(sed -n 's/^val commandNames = "\(.*\)".*/\1/p' build.sbt) "
  local line=${1-}
  local name=${line%%[[:space:]]*}
  [ -n "$name" ] && [[ $names == *" $name "* ]] || return 1
  [ $# = 1 ] || { [ "$name" = "$line" ] && [[ $2 == -* ]]; }
}

# compiled: whether the classes are there and .cache/classpath is newer than every source, and than every folder of
# sources, which change when a file is removed.
compiled() {
  [ -e .cache/classpath ] && [ -e "$(cut -d: -f1 .cache/classpath)/frustum/command/Main.class" ] || return 1
  local sources=(build.sbt project/*.sbt project/build.properties {hw,hw/contract,driver/scala,boards,boards/demos,sim}/src/main)
  [ -z "$(find "${sources[@]}" -newer .cache/classpath 2>/dev/null | head -n 1)" ]
}

run_command() {
  if ! compiled; then
    echo "compiling"
    mkdir -p .cache
    # The mark is set before sbt reads the sources: what is changed meanwhile is compiled next time.
    touch .cache/classpath.start
    if ! java -Xmx2g -Xss8m -Dsbt.color=false -Dsbt.supershell=false -jar "$jar" writeClasspath </dev/null \
      >.cache/compile.log 2>&1; then
      cat .cache/compile.log
      echo "error: the workbench does not compile: see .cache/compile.log" >&2
      exit 1
    fi
    touch -r .cache/classpath.start .cache/classpath
  fi
  if [ $# = 1 ]; then set -- --line "$1"; fi
  # Java takes the names of files in the locale's encoding; without one it finds none that are beyond ASCII.
  case $(locale charmap 2>/dev/null) in
    UTF-8) ;;
    *) export LC_ALL=C.UTF-8 ;;
  esac
  exec java -Xmx4g -Xss8m -cp "$(cat .cache/classpath)" frustum.command.Main "$@"
}
