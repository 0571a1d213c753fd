package frustum
import frustum.blackbox.Tech
import frustum.spec.RasterConfig
import frustum.harness.FrustumSim
import spinal.core._
object ScratchVerilog extends App {
  val dir = "/tmp/fragment/v"
  new java.io.File(dir).mkdirs()
  def gen(c: => Component) = FrustumSim.spinalConfig.copy(targetDirectory = dir, mode = Verilog).generate(c)
  gen(pipelines.FragmentPipeline(RasterConfig(), Tech.Ice40).setDefinitionName("FP"))
}
