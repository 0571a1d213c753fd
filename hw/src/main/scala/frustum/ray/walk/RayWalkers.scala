package frustum.ray.walk

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.RayProgram
import frustum.ray.program.RayRowLoad
import frustum.ray.scene.RayConfig
import spinal.core._
import spinal.lib.misc.pipeline._

/** The walkers of a program's forms, by name. The forms of a pixel advance when they are needed, not when the pixel
  * enters.
  *
  * @param node number of the pipeline's node at which a form is read
  */
class RayWalkers(config: RayConfig, load: RayRowLoad, line: LockstepPipeline, node: String => Int) extends Area {
  import config.program
  private val values = program.forms.map { f =>
    val w = FormWalker(f, program, config.fast).setName("walk_" + f.name)
    w.io.load := load
    w.io.step := line(node(f.name)).isValid
    f.name -> w.io.value
  }.toMap

  def apply(form: String): SInt = values(form)
  def width(form: String): Int = values(form).getWidth
  def negative(form: String): Bool = values(form).msb

  /** A function of a form's value when it is read, for later nodes. It needs no registers if the form is constant along
    * a row.
    */
  def kept[T <: Data](form: String)(of: SInt => T): Node => T = {
    val v = of(values(form))
    if (program.form(form).registers == 1) _ => v
    else {
      val payload = line(node(form)).insert(v)
      at => at(payload)
    }
  }
}
