package frustum.model.ray

import frustum.spec.{RayMotion, RayProgram, RayStep}

/** The set-up's memory and its two programs; each result is checked against the range proved for it. */
class RaySetup(program: RayProgram) {
  private val memory = program.words.map(_.constant.getOrElse(BigInt(0))).toArray

  private def run(step: RayStep): Unit = {
    val (a, b) = (memory(step.a), memory(step.b))
    val result = step.op match {
      case RayStep.Multiply => a * b
      case RayStep.Add      => a + b
      case RayStep.Subtract => a - b
    }
    val range = program.words(step.to).range
    require(range.contains(result), s"word ${step.to} is $result, proved from ${range.low} to ${range.high}")
    memory(step.to) = result
  }

  def frame(motion: RayMotion): Unit = {
    for (i <- program.inputs) {
      val v = (if (i.isSphere) motion.spheres else motion.quads) (i.index)(i.axis)
      require(
        i.range.contains(v),
        s"${if (i.isSphere) "sphere" else "quad"} ${i.index} at $v on axis ${i.axis}, accepted ${i.range.low} to ${i.range.high}"
      )
      memory(i.address) = v
    }
    program.frame.foreach(run)
  }

  /** Words of the row load to come; then the state moves on to the next. */
  def row(): Array[Long] = {
    val registers = Array.tabulate(program.loadWords)(r => memory(program.load + r).toLong)
    program.row.foreach(run)
    registers
  }
}
