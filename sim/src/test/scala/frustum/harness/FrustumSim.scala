package frustum.harness

import frustum.engine.VerilatorSettings
import spinal.core._
import spinal.core.sim._

/** Simulation settings shared by all hardware tests. */
object FrustumSim {
  def spinalConfig: SpinalConfig = SpinalConfig(
    defaultConfigForClockDomains = ClockDomainConfig(resetKind = SYNC),
    defaultClockDomainFrequency = FixedFrequency(48 MHz)
  )

  def config: SpinalSimConfig = VerilatorSettings(spinalConfig)

  /** Compiles a unit under test once; `name` keeps the workspaces of differently configured instances apart.
    */
  def compile[C <: Component](name: String)(unit: => C): SimCompiled[C] =
    config.workspaceName(name).compile(unit)
}
