package frustum.voxel.world

import frustum.contract.voxel.{LeapField, VoxelConfig, WorldSize}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.voxel.world.LeapWords
import frustum.scene.VoxelWorld
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import scala.util.Random

/** Edits by the hardware: after each the world's memory is, word for word, what a host would have made of the new
  * world.
  */
class WorldEditorTest extends AnyFunSuite with Simulated {
  private case class Bench(c: VoxelConfig) extends Component {
    val edit = slave(Stream(BlockEdit(c)))
    val editor = WorldEditor(c)
    val memory = WorldMemory(c)
    edit >> editor.io.edit
    editor.io.read <> memory.io.read
    editor.io.write >> memory.io.write
    memory.words.simPublic()
  }
  private val seed = 1

  for (
    (field, size, edits) <- Seq(
      (LeapField.Quadrants, WorldSize(8, 16, 8), 100),
      (LeapField.Octants, WorldSize(8, 8, 16), 60),
      (LeapField.UpDown, WorldSize(16, 8, 8), 30),
      (LeapField.Chebyshev, WorldSize(8, 8, 8), 20),
      (LeapField(3, 3), WorldSize(8, 32, 4), 10),
      (LeapField.Plain, WorldSize(4, 4, 4), 40)
    )
  ) test(s"leaps are right after $edits edits, $field") {
    val c = VoxelConfig(size = size, leaps = field)
    FrustumSim.compile(s"WorldEditor_${field.mask}_${field.bits}")(Bench(c)).doSim(seed) { dut =>
      val random = new Random(seed)
      dut.edit.valid #= false
      dut.clockDomain.forkStimulus(10)
      // Few blocks, so that long distances are there to be changed.
      var world = VoxelWorld.tabulate(size)((_, _, _) => if (random.nextInt(40) == 0) 1 + random.nextInt(24) else 0)
      dut.clockDomain.waitSampling(3) // before its reset hardware writes what it likes
      for ((w, i) <- LeapWords(world, field).zipWithIndex) dut.memory.words.setBigInt(i, w)
      var longest = 0
      for (n <- 0 until edits) {
        val blocks = world.ids.indices.filter(world.ids(_) != 0)
        val corner = Seq(size.x, size.y, size.z).map(s => Seq(0, s - 1)(random.nextInt(2)))
        val at = random.nextInt(4) match {
          case 0 if blocks.nonEmpty => blocks(random.nextInt(blocks.length))
          case 1                    => size.address(corner(0), corner(1), corner(2))
          case _                    => random.nextInt(size.blocks)
        }
        val id =
          if (world.ids(at) != 0 && random.nextInt(4) > 0) 0 else random.nextInt(25) // also air to air, block to block
        dut.edit.valid #= true
        dut.edit.address #= at
        dut.edit.id #= id
        var clocks = 0
        do { dut.clockDomain.waitSampling(); clocks += 1 } while (!dut.edit.ready.toBoolean && clocks < 1000000)
        dut.edit.valid #= false
        dut.clockDomain.waitSampling(3)
        longest = longest max clocks
        world = world.copy(ids = world.ids.updated(at, id.toByte))
        val right = LeapWords(world, field)
        for (i <- right.indices) assert(
          dut.memory.words.getBigInt(i).toInt == right(i),
          s"seed $seed, edit $n, block $at becomes $id: word $i"
        )
      }
      info(s"at most $longest clocks")
    }
  }
}
