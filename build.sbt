val spinalVersion = "1.14.2"

ThisBuild / organization := "io.github.frustum3d"
ThisBuild / version      := "0.1.0"
ThisBuild / scalaVersion := "2.13.18"
ThisBuild / licenses     := Seq("Apache-2.0" -> url("https://www.apache.org/licenses/LICENSE-2.0"))
ThisBuild / scalacOptions ++= Seq("-deprecation", "-feature", "-unchecked", "-Xlint:infer-any", "-language:reflectiveCalls")
ThisBuild / fork           := true
ThisBuild / connectInput   := false
ThisBuild / outputStrategy := Some(StdoutOutput)

val spinalCore = "com.github.spinalhdl" %% "spinalhdl-core" % spinalVersion
val spinalLib  = "com.github.spinalhdl" %% "spinalhdl-lib"  % spinalVersion
val idslPlugin = compilerPlugin("com.github.spinalhdl" %% "spinalhdl-idsl-plugin" % spinalVersion)

val ujson = "com.lihaoyi" %% "ujson" % "4.1.0"

/** The idsl plugin names signals; without it the generated Verilog is unreadable, so its absence is an error. */
val spinal = Seq(
  libraryDependencies ++= Seq(spinalCore, spinalLib, idslPlugin),
  scalacOptions += "-Xplugin-require:idsl-plugin"
)

lazy val hw = (project in file("hw")).settings(spinal).settings(name := "frustum")

lazy val boards = (project in file("boards"))
  .dependsOn(hw)
  .settings(spinal)
  .settings(name := "frustum-boards", libraryDependencies += ujson)

lazy val sim = (project in file("sim"))
  .enablePlugins(BuildInfoPlugin)
  .dependsOn(boards)
  .settings(spinal)
  .settings(
    name             := "frustum-sim",
    buildInfoKeys    := Seq[BuildInfoKey](version),
    buildInfoPackage := "frustum",
    libraryDependencies ++= Seq(
      "com.github.spinalhdl" %% "spinalhdl-sim" % spinalVersion,
      "org.joml"              % "joml"          % "1.10.8",
      "com.github.scopt"     %% "scopt"         % "4.1.0",
      "me.tongfei"            % "progressbar"   % "0.10.1",
      "org.knowm.xchart"      % "xchart"        % "3.8.8",
      "org.scalatest"        %% "scalatest"     % "3.2.20" % Test
    ),
    Compile / run / baseDirectory := (ThisBuild / baseDirectory).value,
    Test / baseDirectory          := (ThisBuild / baseDirectory).value,
    Test / javaOptions ++= Seq("-Xmx4g"),
    run / javaOptions ++= Seq("-Xmx4g"),
    Test / parallelExecution := false
  )

lazy val frustum = (project in file(".")).aggregate(hw, boards, sim).settings(publish / skip := true)

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
val commandNames = "demo render verilog bitstream bench pong voxel play budgets chart stability fit mutate".split(' ').toSeq
Global / commands ++= commandNames.map { name =>
  Command.args(name, "<args>") { (state, args) =>
    val quoted = args.map(a => if (a.exists(_.isWhitespace)) "\"" + a + "\"" else a)
    s"sim/runMain frustum.command.Main $name ${quoted.mkString(" ")}" :: state
  }
}
