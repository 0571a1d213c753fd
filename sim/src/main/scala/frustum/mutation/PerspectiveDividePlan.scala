package frustum.mutation

import frustum.device.Tech
import frustum.{model, raster}
import frustum.mutation.MutationPlan.values
import scala.util.Random

/** The perspective divide, as `PerspectiveDivideTest` has it: corners of all three operands, then random ones of any
  * size.
  */
object PerspectiveDividePlan {
  private val corners =
    Seq(0, 1, -1, Int.MaxValue, Int.MinValue, 1 << 30, 0x3fffffff, 1 << 15, 0xffff, 1 << 16, 1 << 27, 1 << 26)

  /** s, t, q. */
  def inputs(random: Random, count: Int): Seq[(Int, Int, Int)] =
    (for (q <- corners; s <- corners) yield (s, -s, q)) ++
      Seq.fill(count)((
        random.nextInt() >> random.nextInt(20),
        random.nextInt(),
        random.nextInt() >>> random.nextInt(20)
      ))

  def apply(seed: Long): MutationPlan = {
    val random = new Random(seed)
    val in = inputs(random, 5000)
    def word(v: Int, bits: Int) = v & (1L << bits) - 1
    MutationPlan(
      "PerspectiveDivide",
      () => raster.texture.PerspectiveDivide(Tech.Generic),
      in.flatMap { case (s, t, q) =>
        def step(valid: Boolean, s: Int, t: Int, q: Int) = MutationStep(
          values(
            "io_up_valid" -> (if (valid) 1 else 0),
            "io_up_payload_s" -> word(s, 32),
            "io_up_payload_t" -> word(t, 32),
            "io_up_payload_q" -> word(q, 32)
          ),
          waits = valid
        )
        def any = random.nextInt()
        // At times long enough for a coordinate to be alone in the pipeline.
        val idle = if (random.nextInt(50) == 0) 12 else random.nextInt(4) / 2
        Seq.fill(idle)(step(valid = false, any, any, any)) :+ step(valid = true, s, t, q)
      }.toIndexedSeq,
      waitsFor = Some("io_up_ready"),
      stalled = Seq("io_down_ready"),
      event = Some((Seq("io_down_valid", "io_down_ready"), Seq("io_down_payload_s", "io_down_payload_t"))),
      events = in.map { case (s, t, q) =>
        Seq(s, t).map(v => Some(BigInt(word(model.raster.texture.PerspectiveDivide(v, q), 32))))
      }.toIndexedSeq,
      busy = Some("io_busy")
    )
  }
}
