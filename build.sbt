val spinalVersion = "1.14.2"

ThisBuild / organization := "io.github.frustum3d"
ThisBuild / version := "0.1.0"
ThisBuild / scalaVersion := "2.13.18"
ThisBuild / licenses := Seq("Apache-2.0" -> url("https://www.apache.org/licenses/LICENSE-2.0"))
ThisBuild / scalacOptions ++= Seq(
  "-deprecation",
  "-feature",
  "-unchecked",
  "-Xlint:infer-any",
  "-language:reflectiveCalls"
)
ThisBuild / fork := true
ThisBuild / connectInput := false
ThisBuild / outputStrategy := Some(StdoutOutput)

val spinalCore = "com.github.spinalhdl" %% "spinalhdl-core" % spinalVersion
val spinalLib = "com.github.spinalhdl" %% "spinalhdl-lib" % spinalVersion
val idslPlugin = compilerPlugin("com.github.spinalhdl" %% "spinalhdl-idsl-plugin" % spinalVersion)

val ujson = "com.lihaoyi" %% "ujson" % "4.1.0"

/** The idsl plugin names signals; without it the generated Verilog is unreadable, so its absence is an error. */
val spinal = Seq(
  libraryDependencies ++= Seq(spinalCore, spinalLib, idslPlugin),
  scalacOptions += "-Xplugin-require:idsl-plugin"
)

/** What users of the library depend on is built for SpinalHDL's users of both Scala versions. */
val published = Seq(crossScalaVersions := Seq("2.13.18", "2.12.21"))
val internal = Seq(publish / skip := true)

/** Formats, bit layouts, command table, programs, declared domains, scene values: plain Scala, no SpinalHDL. */
lazy val contract = (project in file("hw/contract")).settings(published).settings(name := "frustum-contract")

lazy val hw = (project in file("hw")).dependsOn(contract).settings(spinal, published).settings(name := "frustum")

/** The driver of a host: matrices, clipping, submission. */
lazy val driver = (project in file("driver/scala"))
  .dependsOn(contract)
  .settings(name := "frustum-driver")

/** Games, players, consoles and their art, which boards and workbench share. */
lazy val demos = (project in file("boards/demos")).dependsOn(hw).settings(spinal, internal)

lazy val boards = (project in file("boards"))
  .dependsOn(demos)
  .settings(spinal, internal)
  .settings(name := "frustum-boards", libraryDependencies += ujson)

/** Every test but those that simulate, prove or synthesise: `./sbt quick`. A test that simulates without its mark fails. */
lazy val Quick = config("quick") extend Test
val marked = Seq("Simulated", "Formal", "Synthesised").flatMap(mark => Seq("-l", s"frustum.harness.$mark"))
val quickSettings = inConfig(Quick)(Defaults.testTasks) ++ Seq(
  Quick / testOptions += Tests.Argument(marked: _*),
  Quick / forkOptions ~= (options => options.withEnvVars(options.envVars + ("FRUSTUM_SIMULATOR" -> "off")))
)
addCommandAlias("quick", "sim/Quick/test")

lazy val sim = (project in file("sim"))
  .enablePlugins(BuildInfoPlugin)
  .configs(Quick)
  .dependsOn(boards, driver)
  .settings(spinal, internal, quickSettings)
  .settings(
    name := "frustum-sim",
    buildInfoKeys := Seq[BuildInfoKey](version),
    buildInfoPackage := "frustum",
    libraryDependencies ++= Seq(
      "com.github.spinalhdl" %% "spinalhdl-sim" % spinalVersion,
      "com.twelvemonkeys.imageio" % "imageio-tga" % "3.13.1",
      "org.jfree" % "jfreechart" % "1.5.6",
      "org.apache.xmlgraphics" % "batik-svggen" % "1.19",
      "com.github.scopt" %% "scopt" % "4.1.0",
      "me.tongfei" % "progressbar" % "0.10.1",
      "org.scalatest" %% "scalatest" % "3.2.20" % Test
    ),
    Compile / run / baseDirectory := (ThisBuild / baseDirectory).value,
    Test / baseDirectory := (ThisBuild / baseDirectory).value,
    Test / javaOptions ++= Seq("-Xmx4g"),
    // With the time of each test, and with all that failed once more at the end, as two suites print in turns.
    Test / testOptions += Tests.Argument("-oDI"),
    run / javaOptions ++= Seq("-Xmx4g"),
    // Two suites at a time: one's model is compiled while the other's is simulated.
    Test / testForkedParallel := true,
    Test / javaOptions += "-XX:ActiveProcessorCount=2"
  )

lazy val frustum = (project in file(".")).aggregate(contract, hw, driver, demos, boards, sim).settings(internal)

/** The class path of the workbench, compiled, for the launcher, which runs commands without sbt around them: their exit
  * code and their stderr are then their own.
  */
val writeClasspath = taskKey[File]("compiles the workbench and writes its class path to .cache/classpath")
writeClasspath := {
  val file = (ThisBuild / baseDirectory).value / ".cache" / "classpath"
  IO.write(file, (sim / Runtime / fullClasspath).value.files.mkString(java.io.File.pathSeparator))
  file
}

/** Every command of the workbench by its name in sbt's own shell; alone on the command line ./sbt takes them itself. */
// project/command.sh reads this line
val commandNames = "demo render verilog bitstream bench pong voxel play budgets chart stability fit mutate report"
Global / commands ++= commandNames.split(' ').toSeq.map { name =>
  Command.args(name, "<args>") { (state, args) =>
    val quoted = args.map(a => if (a.exists(_.isWhitespace)) "\"" + a + "\"" else a)
    s"sim/runMain frustum.command.Main $name ${quoted.mkString(" ")}" :: state
  }
}
