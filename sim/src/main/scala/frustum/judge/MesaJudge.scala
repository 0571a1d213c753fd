package frustum.judge

import frustum.contract.raster.RenderState
import frustum.driver.raster.PreparedFrame
import frustum.reference.raster.{Mesa, PixelRect, ScreenVertex, TriangleAttributes}

/** A model's fragments against Mesa's picture of the same vertices.
  *
  * @param primitiveWrong pixels at which another triangle shows
  * @param judged         textured pixels at which the same one does, clear of texel borders
  * @param wrong          of these, another texel was read
  */
final case class MesaVerdict(primitiveWrong: Long, judged: Long, wrong: Long) {
  def +(o: MesaVerdict): MesaVerdict =
    MesaVerdict(primitiveWrong + o.primitiveWrong, judged + o.judged, wrong + o.wrong)
}

object MesaJudge {

  /** @param logs fragments of each pass
    * @return None where a state has an alpha test, which Mesa would need the texels' colours for
    */
  def judge(mesa: Mesa, frame: PreparedFrame, logs: Seq[IndexedSeq[LoggedFragment]]): Option[MesaVerdict] =
    Option.unless(frame.passes.exists(_.states.exists(_.alphaRef > 0))) {
      val config = frame.config
      frame.passes.zip(logs).map { case (pass, log) =>
        val shown = mesa.triangles(pass, config, depth = true)
        val texels = mesa.texels(pass, config, depth = true)
        val mine = visible(
          pass.triangles.map(t => pass.states(t.state)),
          log,
          config.width * config.height,
          config.width
        )
        val planes = pass.triangles.map { t =>
          new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(pass.vertices(i))))
        }
        val rect = PixelRect.of(pass.region, config)
        val pixels = shown.indices.filter(i => rect.contains(i % config.width, i / config.width))
        val (same, other) = pixels.partition(i => shown(i) == mine(i).fold(-1)(_.triangle))
        val wrong = for {
          i <- same
          f <- mine(i)
          state = pass.states(pass.triangles(f.triangle).state)
          truth = planes(f.triangle)(f.x, f.y)
          _ <- AttributeJudge.one(state, truth, f.texelS, f.texelT)
        } yield !texels(i).contains((f.texelS, f.texelT))
        MesaVerdict(other.length, wrong.length, wrong.count(identity))
      }.reduce(_ + _)
    }

  /** The fragment that shows at each pixel. */
  private def visible(
      states: IndexedSeq[RenderState],
      log: IndexedSeq[LoggedFragment],
      pixels: Int,
      width: Int
  ): Array[Option[LoggedFragment]] = {
    val depth = Array.fill(pixels)(65535)
    val shown = Array.fill(pixels)(Option.empty[LoggedFragment])
    for (f <- log) {
      val (i, state) = (f.y * width + f.x, states(f.triangle))
      if (state.depth.passes(f.depth, depth(i))) {
        shown(i) = Some(f)
        if (state.depthWrite) depth(i) = f.depth
      }
    }
    shown
  }
}
