#!/bin/bash
# Starts sbt: `./sbt demo`, `./sbt test`, `./sbt "render --scene teapot"`. Sees to what the command needs first.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")"
. project/setup.sh
. project/command.sh
refuse_mistyped "$@"
prepare_all "$@"
launcher "$(sed -n 's/^sbt.version=//p' project/build.properties)" \
  1750c8fb61c2d2f82da40b2cd9014f4d8a1bd49a361402ea5b1cec061ed66578
model_settings
if is_command "$@"; then run_command "$@"; fi
exec java -Xmx2g -Xss8m -Dsbt.color=false -Dsbt.supershell=false -jar "$jar" "$@"
