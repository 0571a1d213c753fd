package frustum.engine.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig}
import frustum.engine.EngineSim
import frustum.voxel.march.Direction
import spinal.core.sim._

/** A frame as it was drawn: 0xRRGGBB row by row, clocks from start to last pixel, words of memory read. */
final case class VoxelFrame(picture: Array[Int], clocks: Long, steps: Long)

/** Draws on a running [[VoxelTestbed]]. To be made first thing in the simulation. */
final class VoxelSession(dut: VoxelTestbed) {
  private val c = dut.c
  dut.io.start #= false
  dut.io.edit.valid #= false
  dut.io.highlight #= false
  dut.clockDomain.forkStimulus(EngineSim.Period)
  dut.clockDomain.waitSampling(2)

  /** Puts the words of a world into its memory, by the simulator's back door; those that are there already are left
    * alone.
    */
  def load(words: Array[Int], there: Array[Int] = Array.empty): Unit =
    for (i <- words.indices if !there.lift(i).contains(words(i)))
      dut.pipeline.memory.words.setBigInt(i.toLong, BigInt(words(i)))

  def frame(camera: VoxelCamera, highlight: Boolean): VoxelFrame = {
    def put(port: Direction, v: IntVector): Unit = for (k <- 0 to 2) port.axes(k) #= v(k)
    for (k <- 0 to 2) dut.io.camera.eye(k) #= camera.eye(k)
    put(dut.io.camera.look, camera.look)
    put(dut.io.camera.base, camera.base)
    put(dut.io.camera.right, camera.right)
    put(dut.io.camera.down, camera.down)
    dut.io.highlight #= highlight
    dut.io.start #= true
    dut.clockDomain.waitSampling()
    dut.io.start #= false
    dut.clockDomain.waitSampling()
    var (last, now) = (-1L, 0L)
    while (dut.io.busy.toBoolean) {
      if (now == last) throw new IllegalStateException(
        s"the voxel pipeline hangs: $now of ${c.pixels} pixels after ${dut.io.clocks.toLong} clocks"
      )
      last = now
      sleep(EngineSim.Period * VoxelSession.StepClocks)
      dut.clockDomain.waitSampling()
      now = dut.io.pixels.toLong
    }
    val picture = Array.tabulate(c.pixels)(i => dut.picture.getBigInt(i.toLong).toInt)
    VoxelFrame(picture, dut.io.clocks.toLong, dut.io.steps.toLong)
  }

  /** Block and face pointed at in the frame drawn last. */
  def pointedAt: Option[(Seq[Int], Int)] = Option.when(dut.io.pointedAt.valid.toBoolean)(
    (dut.io.pointedAt.block.map(_.toInt).toSeq, dut.io.pointedAt.face.toInt)
  )
}

object VoxelSession {

  /** Clocks between two looks of the JVM, enough for any ray. */
  val StepClocks = 20000

  def compile(c: VoxelConfig, assets: VoxelAssets): SimCompiled[VoxelTestbed] =
    EngineSim.compile(s"Voxel_${c.size}_${c.width}x${c.height}_${(c, assets).hashCode.toHexString}") {
      val dut = VoxelTestbed(c, assets)
      dut.picture.simPublic()
      dut.pipeline.memory.words.simPublic()
      dut
    }
}
