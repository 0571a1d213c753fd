#!/bin/bash
# Starts sbt: fetches its launcher jar once, by Maven coordinates, and verifies its checksum.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")"
version=$(sed -n 's/^sbt.version=//p' project/build.properties)
sha256=1750c8fb61c2d2f82da40b2cd9014f4d8a1bd49a361402ea5b1cec061ed66578
jar=.cache/sbt-launch-$version.jar
if ! [ -e "$jar" ]; then
  mvn -q dependency:copy "-Dartifact=org.scala-sbt:sbt-launch:$version" -DoutputDirectory=.cache
fi
echo "$sha256  $jar" | sha256sum --check --quiet
exec java -Xmx2g -Xss8m -Dsbt.color=false -Dsbt.supershell=false -jar "$jar" "$@"
