package frustum.contract.ray

import frustum.contract.arithmetic.Interval

/** What the set-up of a ray caster computes, and the forms its pixels are decided by: [[RaySceneForms]].
  *
  * @param size
  *   words of the memory, of `wordWidth` bits each: a word of any range is exact modulo 2^wordWidth, and no form needs
  *   more bits
  * @param constants
  *   by address
  * @param inputs
  *   moving coordinates: address of each, with its range
  * @param frame
  *   steps once per frame, then `row` after every row's load
  * @param loadWords
  *   the first so many words fill the forms' registers, in the forms' order
  */
case class RayProgram(
    size: Int,
    constants: Map[Int, BigInt],
    inputs: Seq[RayInput],
    frame: Seq[RayStep],
    row: Seq[RayStep],
    loadWords: Int,
    forms: Seq[RayForm]
) {
  val wordWidth: Int = (forms.map(_.width) ++ inputs.map(_.range.width)).max
  private val byName = forms.map(f => f.name -> f).toMap
  def form(name: String): RayForm = byName(name)
  require(
    wordWidth <= RayProgram.MaxWidth,
    s"coefficients of the scene need $wordWidth bits, at most ${RayProgram.MaxWidth}: a smaller room, finer units or " +
      "fewer pixels"
  )
}

object RayProgram {
  val MaxWidth = 64

  def apply(scene: RayScene, width: Int, height: Int): RayProgram = {
    val forms = new RaySceneForms(scene, width, height)
    build(forms.builder, forms.wanted.toSeq, forms.inputs.toSeq, height)
  }

  /** Lays the state words out and writes the steps that start and advance them. */
  private def build(
      b: RayProgramBuilder,
      wanted: Seq[(String, RayPolynomial, Interval)],
      inputs: Seq[(RayMoving, Int, RayWord)],
      height: Int
  ): RayProgram = {
    val rows = Interval(0, height)
    // A row's start: word, what is added a row later, and what is added to that.
    final case class State(start: RayWord, slope: RayWord, curve: RayWord) {
      val constant: Option[BigInt] =
        start.constant.filter(_ => Seq(slope, curve).forall(_.constant.contains(BigInt(0))))
      lazy val word = new RayWord(start.range + slope.range * rows + curve.range * rows.square, None)
    }
    val zero = b.constant(0)
    def is0(w: RayWord) = w.constant.contains(BigInt(0))
    val states = wanted.map { case (_, p, _) =>
      val Seq(c, x, y, xx, xy, yy) = p.c
      val value = State(c, b.add(y, yy), b.add(yy, yy))
      val step = State(b.add(x, xx), xy, zero)
      val curve = State(b.add(xx, xx), zero, zero)
      if (!is0(xx)) Seq(value, step, curve) else if (!is0(x) || !is0(xy)) Seq(value, step) else Seq(value)
    }
    val forms = wanted.zip(states).foldLeft(Seq[RayForm]()) { case (made, ((name, _, r), s)) =>
      made :+ RayForm(name, made.lastOption.fold(0)(f => f.first + f.loadWords), s.map(_.constant), r)
    }
    val loadWords = forms.map(_.loadWords).sum
    val load = Array.fill(loadWords)(new RayWord(Interval(0), None)) // a gap where no word follows
    for ((f, s) <- forms.zip(states); i <- 0 until f.loaded) {
      val State(start, slope, curve) = s(i)
      val word = s(i).word
      load(f.first + f.slot(i)) = word
      b.copy(word, start)
      if (is0(curve)) b.advance(word, slope)
      else {
        val moving = new RayWord(slope.range + curve.range * rows, None)
        b.copy(moving, slope)
        b.advance(word, moving)
        b.advance(moving, curve)
      }
    }
    val memory = new RayMemory(b, load.toSeq, inputs.map(_._3))
    RayProgram(
      memory.size,
      memory.constants,
      inputs.map { case (of, axis, w) => RayInput(of, axis, memory(w), w.range) },
      b.frame.toSeq.map(memory.step),
      b.row.toSeq.map(memory.step),
      loadWords,
      forms
    )
  }
}
