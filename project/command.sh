# Runs a command of the workbench, such as ./sbt "render --scene teapot", on its compiled classes and outside of
# sbt, so that exit code and stderr are the command's own. Sourced by ./sbt; `jar` is sbt's launcher.

# command_names: of the workbench, as build.sbt lists them.
command_names() {
  sed -n 's/^val commandNames = "\(.*\)".*/\1/p' build.sbt
}

# is_command WORDS...: one command line, or a command's name followed by its options as words of their own.
is_command() {
  local line=${1-}
  local name=${line%%[[:space:]]*}
  [ -n "$name" ] && [[ " $(command_names) " == *" $name "* ]] || return 1
  [ $# = 1 ] || { [ "$name" = "$line" ] && [[ $2 == -* ]]; }
}

# Names of sbt's own that are nearly one of the workbench's: sbt takes them.
sbt_names="export reboot runner start"

# nearest WORD: the commands that a mistyped one may stand for, at most one letter wrong, missing, too many or changed
# with its neighbour, in words of five letters or more two (optimal string alignment distance).
nearest() {
  command_names | tr ' ' '\n' | awk -v word="$1" '
    function least(a, b) { return a < b ? a : b }
    function distance(a, b, i, j, d) {
      for (i = 0; i <= length(a); i++) d[i, 0] = i
      for (j = 0; j <= length(b); j++) d[0, j] = j
      for (i = 1; i <= length(a); i++)
        for (j = 1; j <= length(b); j++) {
          d[i, j] = least(d[i - 1, j] + 1, d[i, j - 1] + 1)
          d[i, j] = least(d[i, j], d[i - 1, j - 1] + (substr(a, i, 1) != substr(b, j, 1)))
          if (i > 1 && j > 1 && substr(a, i, 1) == substr(b, j - 1, 1) && substr(a, i - 1, 1) == substr(b, j, 1))
            d[i, j] = least(d[i, j], d[i - 2, j - 2] + 1)
        }
      return d[length(a), length(b)]
    }
    distance(word, $0) <= (length(word) < 5 ? 1 : 2)'
}

# refuse_mistyped WORDS...: ends where the first word is nearly a command's name and no name of sbt's. Names of sbt's
# tasks with a project, a capital or a sign are left alone.
refuse_mistyped() {
  local name=${1-}
  name=${name%%[[:space:]]*}
  [[ $name =~ ^[a-z]+$ && " $(command_names) $sbt_names " != *" $name "* ]] || return 0
  local meant
  meant=$(nearest "$name" | paste -sd '|' | sed 's/|/ or /g')
  [ -z "$meant" ] || fail "there is no command '$name'; did you mean $meant? All of them: $(command_names)"
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
