package frustum.engine

import spinal.core.SpinalConfig
import spinal.core.sim._

/** Settings of every simulation by Verilator; nothing else in the sources takes SpinalHDL's `SimConfig`. */
object VerilatorSettings {

  /** Environment variable that forbids simulations when it is `off`, in programs started by a test as well: `./sbt
    * quick` sets it.
    */
  val Variable = "FRUSTUM_SIMULATOR"

  /** Compiled models kept in `simWorkspace/.cache`. The test suite has more than SpinalHDL's 100, and a suite that
    * passes over more models than are kept finds none of them again.
    */
  private val Kept = 1000

  /** @param simulator
    *   what `Variable` says
    * @throws IllegalStateException
    *   when simulations are switched off
    */
  def apply(spinal: SpinalConfig, simulator: Option[String] = sys.env.get(Variable)): SpinalSimConfig = {
    if (simulator.contains("off"))
      throw new IllegalStateException(s"$Variable=off forbids simulations: mark a test that simulates as Simulated")
    // The header is part of what the cache compares: with the commit's hash in it, a commit would compile all anew.
    SimConfig.withConfig(spinal.copy(headerWithRepoHash = false, headerWithDate = false))
      .allOptimisation
      .maxCacheEntries(Kept)
  }
}
