package frustum.model.voxel.wide

import frustum.contract.voxel.{FaceLight, VoxelConfig}

/** Colours of faces, and layers gathered front to back.
  *
  * @param light red, green and blue so far, times 255 / 255
  * @param clear what the layers so far let through, of 255
  */
final case class LayerComposite(light: Seq[Int], clear: Int) {

  /** One layer behind the others.
    *
    * @param alpha 0..15; 15 leaves nothing clear
    */
  def behind(color: Seq[Int], alpha: Int): LayerComposite = {
    val weight = clear * (alpha + (alpha >> 3)) >> 4
    LayerComposite(light.zip(color).map { case (l, c) => l + c * weight }, clear - weight)
  }

  /** 0xRRGGBB, rounded: x / 255 = (x + 128 + (x + 128) / 256) / 256. */
  def color: Int = light.map { x =>
    val y = x + 128; y + (y >> 8) >> 8
  }.foldLeft(0)(_ << 8 | _)
}

object LayerComposite {
  val Empty = LayerComposite(Seq(0, 0, 0), 255)

  /** A texel's colour in the light of its face, perhaps pointed at, in the fog of its distance. */
  def face(texel: Int, face: Int, farSquared: Int, pointedAt: Boolean, c: VoxelConfig): Seq[Int] = {
    val fog = if (c.fog) ((farSquared - c.fogSquared).max(0).toLong * c.fogStep >> 16).toInt else 0
    Seq(12, 8, 4).zip(c.skyChannels).map { case (at, sky) =>
      val lit = FaceLight.lit(texel >> at & 15, VoxelConfig.Light(face))
      val shown = if (pointedAt) FaceLight.highlighted(lit) else lit
      shown + ((sky - shown) * fog >> 8)
    }
  }
}
