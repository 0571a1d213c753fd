package frustum.boards

import frustum.device.Tech

/** A device the flow can build for.
  *
  * @param blockRamKbit all of its block RAM, iCE40's single-port RAM not counted
  */
sealed abstract class Part(val name: String, val packageName: String, val tech: Tech, val blockRamKbit: Int) {

  /** What a report counts, and which of nextpnr's kinds of cells make each figure. */
  def figures: Seq[(String, Seq[String])]
}
object Part {

  /** Lattice iCE40UP5K-SG48: 5,280 logic cells, 30 EBR of 4 kbit, 4 SPRAM of 256 kbit, 8 SB_MAC16. */
  case object Ice40Up5k extends Part("iCE40UP5K", "sg48", Tech.Ice40, 30 * 4) {
    val figures = Seq(
      "logicCells" -> Seq("ICESTORM_LC"),
      "ebr" -> Seq("ICESTORM_RAM"),
      "spram" -> Seq("ICESTORM_SPRAM"),
      "dsp" -> Seq("ICESTORM_DSP")
    )
  }

  /** An Artix-7 of Xilinx in the package CSG324, speed grade 1.
    *
    * @param blockRams of 36 kbit
    */
  sealed abstract class Artix7(name: String, blockRams: Int)
      extends Part(name, s"${name.toLowerCase}csg324-1", Tech.Artix7, blockRams * 36) {
    val figures = Seq(
      "luts" -> Seq("SLICE_LUTX"),
      "ffs" -> Seq("SLICE_FFX"),
      "bram18" -> Seq("RAMB18E1_RAMB18E1"),
      "bram36" -> Seq("RAMB36E1_RAMB36E1", "RAMBFIFO36E1_RAMBFIFO36E1"),
      "dsp48" -> Seq("DSP48E1_DSP48E1")
    )
  }

  /** 20,800 LUT, 41,600 flip-flops, 50 block RAMs of 36 kbit, 90 DSP48E1. */
  case object Artix7A35 extends Artix7("XC7A35T", 50)

  /** 63,400 LUT, 126,800 flip-flops, 135 block RAMs of 36 kbit, 240 DSP48E1. */
  case object Artix7A100 extends Artix7("XC7A100T", 135)

  /** Lattice LFE5U-85F in CABGA381, speed grade 6, the slowest: 83,640 LUT of four inputs and as many flip-flops, 208
    * block RAMs of 18 kbit, 156 multipliers of 18 x 18.
    */
  case object Ecp5U85 extends Part("LFE5U-85F", "CABGA381", Tech.Generic, 208 * 18) {
    val figures = Seq(
      "luts" -> Seq("TRELLIS_COMB"),
      "ffs" -> Seq("TRELLIS_FF"),
      "dp16kd" -> Seq("DP16KD"),
      "mult18" -> Seq("MULT18X18D")
    )
  }
}
