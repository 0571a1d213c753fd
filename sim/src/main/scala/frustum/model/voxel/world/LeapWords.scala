package frustum.model.voxel.world

import frustum.contract.voxel.LeapField
import frustum.scene.VoxelWorld

/** The words of the hardware's world memory for a world. */
object LeapWords {
  def apply(world: VoxelWorld, field: LeapField): Array[Int] = {
    val size = world.size
    val groups = (0 until field.groups).map(distances(world, field, _))
    Array.tabulate(size.blocks) { i =>
      if (world.ids(i) != 0) field.wordOfBlock(world.ids(i)) else field.wordOfAir(groups.map(_(i).toInt))
    }
  }

  /** For each block of air the side of the largest cube in all octants of a group. A cube of side n + 1 is air where
    * those of side n at the block and at its neighbours on that side are: so each round adds one.
    */
  private def distances(world: VoxelWorld, field: LeapField, group: Int): Array[Byte] = {
    val size = world.size
    val neighbours = for {
      dx <- steps(field.side(group, 0)); dy <- steps(field.side(group, 1)); dz <- steps(field.side(group, 2))
      if (dx, dy, dz) != ((0, 0, 0))
    } yield (dx, dy, dz)
    var now = Array.tabulate[Byte](size.blocks)(i => if (world.ids(i) == 0) 1 else 0)
    for (side <- 1 until field.most) {
      val next = now.clone
      for (x <- 0 until size.x; y <- 0 until size.y; z <- 0 until size.z) {
        val i = size.address(x, y, z)
        if (
          now(i) == side && neighbours.forall { case (dx, dy, dz) =>
            !size.contains(x + dx, y + dy, z + dz) || now(size.address(x + dx, y + dy, z + dz)) >= side
          }
        ) next(i) = (side + 1).toByte
      }
      now = next
    }
    now
  }

  private def steps(side: Int): Seq[Int] = if (side == 0) Seq(-1, 0, 1) else Seq(0, side)
}
