package frustum.boards

/** The table of everything that can be built for a board. */
object Tops {
  val all: Seq[BoardTop] = Seq(
    icebreaker.IcebreakerTops.raster,
    icebreaker.IcebreakerTops.pong,
    icebreaker.IcebreakerTops.voxel,
    arty.ArtyTops.pong,
    arty.ArtyTops.voxel,
    arty.ArtyTops.voxel35
  )

  def find(name: String): Option[BoardTop] = all.find(_.name == name)
}
