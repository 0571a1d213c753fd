package frustum.scene

import frustum.contract.voxel.{BlockTable, BlockType, VoxelAssets, VoxelTextures}
import scala.collection.immutable.ListMap

/** A colour that blocks are wanted for: four bits a channel, as texels have them.
  *
  * @param rgba RGBA4444; alpha 15 is opaque
  */
final case class BlockColor(rgba: Int) {
  def opaque: Boolean = (rgba & 15) == 15
  def channels: Seq[Double] = Seq(12, 8, 4).map(at => (rgba >> at & 15) * 17.0)
  override def toString = f"#${rgba >> 4}%03x"
}

object BlockColor {

  /** @param seeThrough 0 for an opaque colour, otherwise the share of light that passes; glass is never quite either */
  def apply(rgb: Int, seeThrough: Double): BlockColor = {
    def four(at: Int) = ((rgb >> at & 255) * 15 + 127) / 255
    val alpha = if (seeThrough == 0) 15 else (15 * (1 - seeThrough)).round.toInt.max(1).min(14)
    BlockColor(four(16) << 12 | four(8) << 8 | four(0) << 4 | alpha)
  }
}

/** Blocks for the colours of a model.
  *
  * @param ids     the block of each colour
  * @param nearest colours that have no block of their own
  */
final case class ColorBlocks(assets: VoxelAssets, ids: Map[BlockColor, Int], nearest: Int)

object ColorBlocks {

  /** Half a step of a texel's four bits a channel: colours that are nearer are the same to the eye of the hardware. */
  private val Tolerance = 17 / 2.0

  private val Nothing = VoxelAssets(BlockTable(IndexedSeq.empty), VoxelTextures(IndexedSeq.empty, IndexedSeq.empty))

  /** Colours in the order of their importance each get the textured block of `offered` whose six faces all have that
    * mean colour, or else a plain one, while the table and the textures have room; further ones the nearest of the
    * blocks that there are, by the sum of the squared distances over its faces. None where there is no opaque block
    * for an opaque colour.
    *
    * @param keep whether all of `offered` stays in the table, under its ids; otherwise the table has what is needed
    *   alone
    * @param grow whether plain blocks may be added
    */
  def choose(colors: Seq[BlockColor], offered: VoxelAssets, keep: Boolean, grow: Boolean): Option[ColorBlocks] = {
    val means = meansOf(offered)
    def textured(color: BlockColor) = Option.when(color.opaque)(offered.table.ids.filter { id =>
      offered.table(id).opaque && means(id - 1).forall(face =>
        face.zip(color.channels).forall { case (a, b) => (a - b).abs <= Tolerance }
      )
    }).flatMap(_.minByOption(id => distance(means(id - 1), color)))

    val start = (if (keep) offered else Nothing, ListMap.empty[BlockColor, Int])
    val (assets, own) = colors.foldLeft(start) { case ((assets, own), color) =>
      val same = textured(color)
      val grown =
        if (keep && same.isDefined) Some((assets, same.get))
        else if (same.isDefined) add(assets, offered.table(same.get), facesOf(offered, same.get))
        else if (grow) add(assets, plain(color), Seq.fill(6)(plainTexture(color)))
        else None
      grown.fold((assets, own)) { case (more, id) => (more, own.updated(color, id)) }
    }
    val found = meansOf(assets)
    val rest = colors.filterNot(own.contains).map { color =>
      val clear = if (color.opaque) Nil else assets.table.ids.filter(!assets.table(_).opaque)
      val among = if (clear.nonEmpty) clear else assets.table.ids.filter(assets.table(_).opaque)
      color -> among.minByOption(id => distance(found(id - 1), color))
    }
    Option.when(rest.forall(_._2.isDefined))(
      ColorBlocks(assets, own ++ rest.map { case (color, id) => color -> id.get }, rest.length)
    )
  }

  private type Texture = (IndexedSeq[Int], IndexedSeq[Int]) // indices, palette

  private def facesOf(assets: VoxelAssets, id: Int): Seq[Texture] =
    assets.table(id).textures.map(t => (assets.textures.indices(t), assets.textures.palettes(t)))

  private def plain(color: BlockColor) =
    BlockType(color.toString, Seq.fill(6)(0), opaque = color.opaque, joins = !color.opaque)
  private def plainTexture(color: BlockColor): Texture = (
    IndexedSeq.fill(VoxelTextures.Side * VoxelTextures.Side)(0),
    color.rgba +: IndexedSeq.fill(VoxelTextures.Colors - 1)(0)
  )

  /** The block with its textures added, and its id; one that is there already is found again. None without room. */
  private def add(to: VoxelAssets, block: BlockType, faces: Seq[Texture]): Option[(VoxelAssets, Int)] = {
    val old = to.textures.indices.zip(to.textures.palettes)
    val all = old ++ faces.distinct.filterNot(old.contains)
    val added = block.copy(textures = faces.map(all.indexOf(_)))
    val blocks = to.table.blocks
    blocks.indexOf(added) match {
      case -1 =>
        Option.when(blocks.length < BlockTable.Most && all.length <= VoxelTextures.Most)(
          (VoxelAssets(BlockTable(blocks :+ added), VoxelTextures(all.map(_._1), all.map(_._2))), blocks.length + 1)
        )
      case i => Some((to, i + 1))
    }
  }

  /** Mean colours of each block's six faces, channels of 0 to 255. */
  private def meansOf(assets: VoxelAssets): IndexedSeq[Seq[Seq[Double]]] = {
    val textures = assets.textures.indices.indices.map { t =>
      val texels = for (v <- 0 until VoxelTextures.Side; u <- 0 until VoxelTextures.Side) yield assets.textures(t, u, v)
      Seq(12, 8, 4).map(at => texels.map(_ >> at & 15).sum * 17.0 / texels.length)
    }
    assets.table.blocks.map(_.textures.map(textures))
  }

  private def distance(faces: Seq[Seq[Double]], color: BlockColor): Double =
    faces.map(_.zip(color.channels).map { case (a, b) => (a - b) * (a - b) }.sum).sum
}
