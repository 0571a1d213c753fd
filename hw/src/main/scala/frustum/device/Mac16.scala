package frustum.device

import spinal.core._

/** SB_MAC16 of the iCE40 UltraPlus (Lattice TN1295). All operands are registered; held while CE is low.
  *
  *   - as a 16 x 16 multiplier the result is registered too, so that all paths end at registers: it comes two cycles
  *     after the operands
  *   - as a pair of 8 x 8 multipliers (`pair`) it comes one cycle after them, by way of multiplier and adder, about 11
  *     ns
  *
  * @param add
  *   O = A * B + {C, D} by the block's adders, or {C, D} - A * B while both ADDSUB are high, otherwise O = A * B and
  *   C, D are not used
  * @param pair
  *   with `add`: O = {C + A[15:8] * B[15:8], D + A[7:0] * B[7:0]}
  */
case class Mac16(signedA: Boolean, signedB: Boolean, add: Boolean, pair: Boolean = false) extends BlackBox {
  require(add || !pair, "Mac16: a pair of multipliers without add")
  setDefinitionName("SB_MAC16")
  private def bit(on: Boolean) = B(if (on) 1 else 0, 1 bits)
  private def output = B(if (pair) 0 else if (add) 1 else 3, 2 bits) // the adder, its register, or the product's
  private def product =
    B(if (pair) 1 else if (add) 2 else 0, 2 bits) // the adder's operand: a product of 8 x 8 or 16 x 16
  private def carry = B(if (add && !pair) 2 else 0, 2 bits) // the lower adder's carry into the upper
  addGeneric("NEG_TRIGGER", bit(false))
  addGeneric("A_REG", bit(true))
  addGeneric("B_REG", bit(true))
  addGeneric("C_REG", bit(add))
  addGeneric("D_REG", bit(add))
  addGeneric("TOP_8x8_MULT_REG", bit(false))
  addGeneric("BOT_8x8_MULT_REG", bit(false))
  addGeneric("PIPELINE_16x16_MULT_REG1", bit(false))
  addGeneric("PIPELINE_16x16_MULT_REG2", bit(!add)) // the product's register
  addGeneric("TOPOUTPUT_SELECT", output)
  addGeneric("TOPADDSUB_LOWERINPUT", product)
  addGeneric("TOPADDSUB_UPPERINPUT", bit(add))
  addGeneric("TOPADDSUB_CARRYSELECT", carry)
  addGeneric("BOTOUTPUT_SELECT", output)
  addGeneric("BOTADDSUB_LOWERINPUT", product)
  addGeneric("BOTADDSUB_UPPERINPUT", bit(add))
  addGeneric("BOTADDSUB_CARRYSELECT", B(0, 2 bits))
  addGeneric("MODE_8x8", bit(pair))
  addGeneric("A_SIGNED", bit(signedA))
  addGeneric("B_SIGNED", bit(signedB))

  val io = new Bundle {
    val CLK, CE = in Bool ()
    val A, B, C, D = in Bits (16 bits)
    val AHOLD, BHOLD, CHOLD, DHOLD = in Bool ()
    val IRSTTOP, IRSTBOT, ORSTTOP, ORSTBOT = in Bool ()
    val OLOADTOP, OLOADBOT, ADDSUBTOP, ADDSUBBOT, OHOLDTOP, OHOLDBOT = in Bool ()
    val CI, ACCUMCI, SIGNEXTIN = in Bool ()
    val O = out Bits (32 bits)
    val CO, ACCUMCO, SIGNEXTOUT = out Bool ()
  }
  noIoPrefix()
  mapCurrentClockDomain(io.CLK)

  /** What plain products do not use is off: holds, resets, loads, subtraction, carries; but for `besides`. */
  def idle(besides: Bool*): Unit = Seq(
    io.AHOLD,
    io.BHOLD,
    io.CHOLD,
    io.DHOLD,
    io.IRSTTOP,
    io.IRSTBOT,
    io.ORSTTOP,
    io.ORSTBOT,
    io.OLOADTOP,
    io.OLOADBOT,
    io.OHOLDTOP,
    io.OHOLDBOT,
    io.ADDSUBTOP,
    io.ADDSUBBOT,
    io.CI,
    io.ACCUMCI,
    io.SIGNEXTIN
  ).filterNot(input => besides.exists(_ eq input)).foreach(_ := False)
}
