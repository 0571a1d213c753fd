package frustum.raster.fragment

import frustum.contract
import frustum.contract.raster.RasterConfig
import frustum.device.{ConditionalAdder, Tech}
import frustum.raster.store.RenderStateWord
import frustum.raster.texture.Texel
import spinal.core._
import spinal.lib._

/** Colour of the fragment from texel and vertex colour: OpenGL's texture environments; one per cycle, latency 1 cycle;
  * the receiver has to register the result.
  *
  * One product per channel serves all modes: (t * (c + c[7]) + 128) >> 8 with t the texel's 5 or 6 bits and c
  * the vertex's 8. It is exact at c = 0 and c = 255; Replace puts 255 for c, ColorOnly puts all ones for t,
  * which rounds c to the frame buffer's bits. An RGB565 texel has no alpha: the vertex's is kept.
  *
  * Where every state uses the texel alone there is nothing to combine, and no latency.
  */
case class Combine(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val up = slave(Stream(TexturedFragment(config)))
    val state = in(RenderStateWord())
    val down = master(Stream(ColoredFragment(config)))
  }

  case class Operands() extends Bundle {
    val x = UInt(config.tileLog2Width bits)
    val y = UInt(config.tileLog2Height bits)
    val texel = Texel()
    val r, g, b, a = UInt(9 bits) // factors, 0..256
    val tileEnd = Bool()
  }

  val colorOnly = io.state.combine === contract.raster.Combine.ColorOnly.code
  val replace = io.state.combine === contract.raster.Combine.Replace.code

  lazy val operands = io.up
    .translateWith {
      val next = Operands()
      val from = io.up.payload
      next.x := from.attributes.x
      next.y := from.attributes.y
      next.tileEnd := from.attributes.tileEnd
      next.texel.assignFromBits(from.texel.asBits | colorOnly #* widthOf(from.texel))
      next.r := factor(from.attributes.r, replace)
      next.g := factor(from.attributes.g, replace)
      next.b := factor(from.attributes.b, replace)
      next.a := factor(from.attributes.a, replace && io.state.texelFormat)
      next
    }
    .m2sPipe(collapsBubble = false)

  lazy val combined = operands
    .translateWith {
      val next = ColoredFragment(config)
      val from = operands.payload
      next.x := from.x
      next.y := from.y
      next.r := product(from.texel.r, from.r)
      next.g := product(from.texel.g, from.g)
      next.b := product(from.texel.b, from.b)
      next.a := product(from.texel.a, from.a)
      next.tileEnd := from.tileEnd
      next
    }

  /** c + c[7] of the clamped c, or 256 for `one`; the lower bits get their clamping from a register's reset. */
  def factor(c: UInt, one: Bool): UInt = {
    val full = one || c(8) && !c(7)
    Mux(c(8) || one, (full ## B(0, 8 bits)).asUInt, c.take(8).asUInt +^ c(7).asUInt)
  }

  /** (t * factor + 128) >> 8, t by its lower three bits and its upper ones side by side, one addition for each bit from
    * the lowest; since factor is 256 at most and every sum is halved, none exceeds 511.
    */
  def product(t: UInt, factor: UInt): UInt = {
    def rows(bits: Seq[Bool], start: Int): (UInt, Seq[Bool]) = {
      var sum = U(start, 9 bits)
      var dropped = Seq.empty[Bool]
      for (bit <- bits) {
        val row = ConditionalAdder(9, tech)
        row.io.condition := bit
        row.io.a := sum
        row.io.b := factor
        dropped = dropped :+ row.io.result.lsb
        sum = row.io.result |>> 1
      }
      (sum, dropped)
    }
    val (lower, _) = rows(t.asBools.take(3).toSeq, 128)
    val (upper, fraction) = rows(t.asBools.drop(3).toSeq, 0)
    val exact = upper ## Cat(fraction) // in units of 2^3, as lower
    (exact.asUInt + lower).drop(5).asUInt.resize(widthOf(t))
  }

  /** Nothing to be combined. */
  def texelAlone: Stream[ColoredFragment] = io.up.translateWith {
    val next = ColoredFragment(config)
    next.assignSomeByName(io.up.texel)
    next.x := io.up.attributes.x
    next.y := io.up.attributes.y
    next.tileEnd := io.up.attributes.tileEnd
    next
  }

  io.down << (if (config.fixed.texelsAlone) texelAlone else combined)
}
