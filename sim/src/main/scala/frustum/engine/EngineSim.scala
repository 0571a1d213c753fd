package frustum.engine

import frustum.contract.raster.{RasterConfig, RenderStateLayout, WalkerKind}
import frustum.files.OutputFile
import spinal.core._
import spinal.core.sim._
import java.nio.file.{Files, Path, StandardCopyOption}
import scala.collection.mutable
import scala.jdk.CollectionConverters._
import scala.util.Using

/** Compiles simulations for the engines, each only once in the life of the program (and Verilator's work, kept in
  * `simWorkspace`, only once as long as the hardware stays as it is).
  */
object EngineSim {
  private final class Once(make: => SimCompiled[_]) { lazy val sim: SimCompiled[_] = make }

  private val compiled = mutable.Map.empty[(String, Option[String]), Once]

  /** Units of simulation time in a clock. */
  val Period = 10L

  def spinalConfig: SpinalConfig = SpinalConfig(
    defaultConfigForClockDomains = ClockDomainConfig(resetKind = SYNC),
    defaultClockDomainFrequency = FixedFrequency(36 MHz)
  )

  /** Everything of a configuration, for names of simulations. */
  def nameOf(config: RasterConfig): String = {
    import config._
    val constant = RenderStateLayout.fields.map(f => f"${fixed(f).mask}%x-${fixed(f).value}%x").mkString("-")
    s"${width}x${height}_${tileWidth}x${tileHeight}_${maxVertices}_${maxTriangles}_${textureTexels}_" +
      s"${constant}_${formats.coordinate}_${formats.depth}_${formats.color}_${formats.inverse}_" +
      s"${ranges.position}_${ranges.repeats}_${ranges.ratio}_${clearColor.fold("any")(_.toString)}_$slots" +
      (if (countUndrawn) "" else "_uncounted") + (if (walker == WalkerKind.Serial) "" else s"_$walker")
  }

  /** @param name must tell everything that the design depends on
    * @param wave file that is to take a waveform: VCD where its name ends so, else FST
    */
  def compile[C <: Component](name: String, wave: Option[Path] = None)(design: => C): SimCompiled[C] = {
    val kind = wave.map(file => if (file.toString.endsWith(".vcd")) "vcd" else "fst")
    def make(): SimCompiled[C] = {
      println(s"$name: compiling the simulation; this takes a minute or two the first time")
      val settings = VerilatorSettings(spinalConfig).workspaceName(name + kind.fold("")("_" + _))
      val waved = kind match {
        case Some("vcd") => settings.withVcdWave
        case Some(_)     => settings.withFstWave
        case None        => settings
      }
      waved.compile(design)
    }
    // Whoever wants the same simulation waits for it; others are compiled meanwhile.
    val once = synchronized(compiled.getOrElseUpdate((name, kind), new Once(make())))
    once.sim.asInstanceOf[SimCompiled[C]]
  }

  /** Lets so many clocks of a domain pass, all that the simulation does beside them included. */
  def clocks(domain: ClockDomain)(n: Long): Unit = {
    sleep(Period * (n - 1))
    domain.waitSampling()
  }

  /** Runs a simulation and moves its waveform to where it is wanted. */
  def run[C <: Component, A](sim: SimCompiled[C], wave: Option[Path], seed: Long)(body: C => A): A = {
    var result = Option.empty[A]
    sim.doSim("run", seed.toInt)(dut => result = Some(body(dut)))
    wave.foreach(takeWave(sim, _))
    result.get
  }

  private def takeWave(sim: SimCompiled[_], to: Path): Unit = {
    val kind = if (to.toString.endsWith(".vcd")) ".vcd" else ".fst"
    val files = Using.resource(Files.walk(sim.compiledPath.toPath))(_.iterator.asScala.toSeq)
    val found = files.filter(_.toString.endsWith(kind)).sortBy(Files.getLastModifiedTime(_)).lastOption
    val file = found.getOrElse(throw new IllegalStateException(s"the simulation wrote no $kind file"))
    OutputFile.write(to)(part => Files.move(file, part, StandardCopyOption.REPLACE_EXISTING))
  }
}
