package frustum.raster.fragment

import frustum.contract.raster.{Combine, DepthFunction, RenderState, RenderStateLayout, TexelFormat, TextureRef, Wrap}
import frustum.raster.store.RenderStateWord
import spinal.core._
import spinal.core.sim._

import scala.util.Random

/** Drives and draws lots for render states in tests. */
object StateSim {
  def drive(to: RenderStateWord, state: RenderState): Unit = {
    val words = state.words
    for (field <- RenderStateLayout.fields) to.value(field) match {
      case flag: Bool        => flag #= field.of(words) == 1
      case number: BitVector => number #= field.of(words)
    }
  }

  def random(r: Random, texels: Int = 32768): RenderState = {
    val log2Width = 3 + r.nextInt(5)
    val log2Height = 3 + r.nextInt(5)
    val free = (texels - (1 << log2Width + log2Height)) / 64
    val format = if (r.nextBoolean()) TexelFormat.Rgb565 else TexelFormat.Rgba4444
    val texture = Option.when(free >= 0)(TextureRef(r.nextInt(free + 1), log2Width, log2Height, format))
    val combines =
      if (texture.isEmpty) Seq(Combine.ColorOnly)
      else Seq(Combine.ColorOnly, Combine.Replace, Combine.Modulate)
    RenderState(
      texture,
      Wrap.all(r.nextInt(3)),
      Wrap.all(r.nextInt(3)),
      combines(r.nextInt(combines.length)),
      DepthFunction.decode(r.nextInt(8)),
      r.nextInt(4) > 0,
      r.nextBoolean(),
      if (r.nextBoolean()) 0 else r.nextInt(32)
    )
  }
}
