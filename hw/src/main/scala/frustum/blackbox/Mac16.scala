package frustum.blackbox

import spinal.core._

/** SB_MAC16 of the iCE40 UltraPlus (Lattice TN1295) as a 16 x 16 multiplier with input and output registers, so that
  * all its timing lies at registers: result two clocks after the operands, both stages held while CE is low.
  * The registers inside the multiplier and the accumulators are not used.
  */
case class Mac16(signedA: Boolean, signedB: Boolean) extends BlackBox {
  setDefinitionName("SB_MAC16")
  private def bit(on: Boolean) = B(if (on) 1 else 0, 1 bits)
  addGeneric("NEG_TRIGGER", bit(false))
  addGeneric("A_REG", bit(true))
  addGeneric("B_REG", bit(true))
  addGeneric("C_REG", bit(false))
  addGeneric("D_REG", bit(false))
  addGeneric("TOP_8x8_MULT_REG", bit(false))
  addGeneric("BOT_8x8_MULT_REG", bit(false))
  addGeneric("PIPELINE_16x16_MULT_REG1", bit(false))
  addGeneric("PIPELINE_16x16_MULT_REG2", bit(true)) // the registered 32-bit product
  addGeneric("TOPOUTPUT_SELECT", B(3, 2 bits)) // product, upper half
  addGeneric("TOPADDSUB_LOWERINPUT", B(0, 2 bits))
  addGeneric("TOPADDSUB_UPPERINPUT", bit(false))
  addGeneric("TOPADDSUB_CARRYSELECT", B(0, 2 bits))
  addGeneric("BOTOUTPUT_SELECT", B(3, 2 bits)) // product, lower half
  addGeneric("BOTADDSUB_LOWERINPUT", B(0, 2 bits))
  addGeneric("BOTADDSUB_UPPERINPUT", bit(false))
  addGeneric("BOTADDSUB_CARRYSELECT", B(0, 2 bits))
  addGeneric("MODE_8x8", bit(false))
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
}
