package frustum.model.ray.program

import frustum.contract.ray.{RayMotion, RayProgram, RayScene, RayStep}

/** The forms of [[RayProgram]] along the rows of a picture, in words of 64 bits that wrap: every form's value is the
  * same as with [[RaySetup]], which also holds each step against its proved range.
  */
final class RayRows(program: RayProgram, scene: RayScene, width: Int, height: Int) {
  private val memory = Array.tabulate(program.size)(a => program.constants.getOrElse(a, BigInt(0)).toLong)
  private val frameSteps = compiled(program.frame)
  private val rowSteps = compiled(program.row)
  private val forms = program.forms.toArray
  private val starts = Array.fill(3)(new Array[Long](forms.length)) // value, step, curve at the row's start
  private val fixed = forms.map(f => (0 to 2).map(d => f.start.lift(d).flatten.fold(0L)(_.toLong)).toArray)
  private val places = forms.map(f => (0 to 2).map(d => if (d < f.loaded) f.first + f.slot(d) else -1).toArray)
  private val index = forms.map(_.name).zipWithIndex.toMap

  /** The number of a form, by its name. */
  def apply(name: String): Int = index(name)

  /** Operation, result and operands of each step. */
  private def compiled(steps: Seq[RayStep]): Array[Int] = steps.flatMap(s => Seq(s.op, s.to, s.a, s.b)).toArray

  private def run(steps: Array[Int]): Unit = {
    var i = 0
    while (i < steps.length) {
      val a = memory(steps(i + 2))
      val b = memory(steps(i + 3))
      memory(steps(i + 1)) = steps(i) match {
        case RayStep.Multiply => a * b
        case RayStep.Add      => a + b
        case RayStep.Subtract => a - b
      }
      i += 4
    }
  }

  /** Begins a picture. */
  def frame(motion: RayMotion): Unit = {
    scene.camera.refuses(motion.cameraOf(scene), width, height).foreach(what => require(false, what))
    for (i <- program.inputs) {
      val v = i.of.in(motion, scene)(i.axis)
      require(i.range.contains(v), s"${i.of} at $v on axis ${i.axis}, accepted ${i.range.low} to ${i.range.high}")
      memory(i.address) = v
    }
    run(frameSteps)
  }

  /** Goes to the next row. */
  def row(): Unit = {
    var i = 0
    while (i < forms.length) {
      var d = 0
      while (d < 3) {
        val place = places(i)(d)
        starts(d)(i) = if (place >= 0) memory(place) else fixed(i)(d)
        d += 1
      }
      i += 1
    }
    run(rowSteps)
  }

  /** At pixel x of the row: value + x step + x (x - 1) / 2 curve. */
  def at(form: Int, x: Int): Long =
    starts(0)(form) + x * starts(1)(form) + x.toLong * (x - 1) / 2 * starts(2)(form)

  /** From pixel x of the row to the next. */
  def step(form: Int, x: Int): Long = starts(1)(form) + x * starts(2)(form)
  def curve(form: Int): Long = starts(2)(form)
}
