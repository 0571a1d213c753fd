package frustum.model.ray.program

import frustum.contract.ray.{RayMotion, RayProgram, RayScene, RayStep}

/** The set-up's memory and its two programs; each result is checked against the range proved for it. */
class RaySetup(program: RayProgram, scene: RayScene, width: Int, height: Int) {
  private val memory = Array.tabulate(program.size)(a => program.constants.getOrElse(a, BigInt(0)))

  private def run(step: RayStep): Unit = {
    val (a, b) = (memory(step.a), memory(step.b))
    val result = step.op match {
      case RayStep.Multiply => a * b
      case RayStep.Add      => a + b
      case RayStep.Subtract => a - b
    }
    require(
      step.range.contains(result),
      s"word ${step.to} is $result, proved from ${step.range.low} to ${step.range.high}"
    )
    memory(step.to) = result
  }

  def frame(motion: RayMotion): Unit = {
    scene.camera.refuses(motion.cameraOf(scene), width, height).foreach(what => require(false, what))
    for (i <- program.inputs) {
      val v = i.of.in(motion, scene)(i.axis)
      require(
        i.range.contains(v),
        s"${i.of} at $v on axis ${i.axis}, accepted ${i.range.low} to ${i.range.high}"
      )
      memory(i.address) = v
    }
    program.frame.foreach(run)
  }

  /** Words of the row load to come; then the state moves on to the next. */
  def row(): Array[Long] = {
    val words = Array.tabulate(program.loadWords)(memory(_).toLong)
    program.row.foreach(run)
    words
  }
}
