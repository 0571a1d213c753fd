package frustum.engine.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig}
import frustum.engine.EngineSim
import spinal.core.sim._

/** Draws on a running [[CompactVoxelTestbed]]. To be made first thing in the simulation. Pictures are 0xRRGGBB, of
  * RGB565.
  */
final class CompactVoxelSession(dut: CompactVoxelTestbed) {
  private val c = dut.c
  dut.io.start #= false
  dut.io.edit.valid #= false
  dut.io.camera.valid #= false
  dut.io.commit #= false
  dut.io.pace #= 0
  dut.io.stalls #= false
  dut.io.highlight #= false
  dut.clockDomain.forkStimulus(EngineSim.Period)
  dut.clockDomain.waitSampling(300)

  /** Puts the words of a world into its memory, by the simulator's back door: two in each of the memory's. */
  def load(words: Array[Int]): Unit =
    for (i <- words.indices by 2)
      dut.pipeline.memory.ram.inferred.setBigInt(i / 2L, BigInt(words(i) | words(i + 1) << 8))

  def edit(address: Int, word: Int): Unit = {
    dut.io.edit.valid #= true
    dut.io.edit.address #= address
    dut.io.edit.word #= word
    dut.clockDomain.waitSamplingWhere(dut.io.edit.ready.toBoolean)
    dut.io.edit.valid #= false
  }

  def camera(camera: VoxelCamera, commit: Boolean = true): Unit = {
    for ((number, i) <- camera.numbers.zipWithIndex) {
      dut.io.camera.valid #= true
      dut.io.camera.index #= i
      dut.io.camera.value #= number
      dut.clockDomain.waitSampling()
    }
    dut.io.camera.valid #= false
    dut.io.commit #= commit
    dut.clockDomain.waitSampling()
    dut.io.commit #= false
    dut.clockDomain.waitSampling()
  }

  /** @param pace clocks after a pixel until the next is taken, at least
    * @param stalls now and then twice as many
    */
  def start(highlight: Boolean, pace: Int = 0, stalls: Boolean = false): Unit = {
    dut.io.stalls #= stalls
    dut.io.highlight #= highlight
    dut.io.pace #= pace
    dut.io.start #= true
    dut.clockDomain.waitSampling()
    dut.io.start #= false
    dut.clockDomain.waitSampling()
  }

  def finish(): VoxelFrame = {
    var (last, now) = (-1L, 0L)
    while (dut.io.busy.toBoolean) {
      if (now == last) throw new IllegalStateException(
        s"the small voxel pipeline hangs: $now of ${c.pixels} pixels after ${dut.io.clocks.toLong} clocks"
      )
      last = now
      sleep(EngineSim.Period * VoxelSession.StepClocks)
      dut.clockDomain.waitSampling()
      now = dut.io.pixels.toLong
    }
    val picture =
      Array.tabulate(c.pixels)(i => CompactVoxelSession.rgb888(dut.picture.getBigInt(i.toLong).toInt))
    VoxelFrame(picture, dut.io.clocks.toLong, dut.io.steps.toLong)
  }

  def frame(camera: VoxelCamera, highlight: Boolean, pace: Int = 0, stalls: Boolean = false): VoxelFrame = {
    this.camera(camera)
    start(highlight, pace, stalls)
    finish()
  }

  /** Block and face pointed at in the frame drawn last. */
  def pointedAt: Option[(Seq[Int], Int)] = Option.when(dut.io.pointedAt.valid.toBoolean)(
    (dut.io.pointedAt.block.map(_.toInt).toSeq, dut.io.pointedAt.face.toInt)
  )
}

object CompactVoxelSession {

  /** Clocks between the pixels that icebreaker-voxel's display takes: 16 bits, one a clock. */
  val DisplayPace = 15

  /** What is left of 0xRRGGBB. */
  def rgb565(rgb: Int): Int = rgb >> 8 & 0xf800 | rgb >> 5 & 0x7e0 | rgb >> 3 & 0x1f

  /** As displays do: the upper bits again below. */
  def rgb888(color: Int): Int = {
    val (r, g, b) = (color >> 11, color >> 5 & 63, color & 31)
    (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | b << 3 | b >> 2
  }
  def shown(rgb: Int): Int = rgb888(rgb565(rgb))

  def compile(c: VoxelConfig, assets: VoxelAssets): SimCompiled[CompactVoxelTestbed] =
    EngineSim.compile(s"SmallVoxel_${c.size}_${c.width}x${c.height}_${(c, assets).hashCode.toHexString}") {
      val dut = CompactVoxelTestbed(c, assets)
      dut.picture.simPublic()
      dut.pipeline.memory.ram.inferred.simPublic()
      dut
    }
}
