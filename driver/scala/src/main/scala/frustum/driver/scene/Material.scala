package frustum.driver.scene

import frustum.contract.raster.{Combine, Wrap}

/** How the triangles that name it look.
  *
  * @param color
  *   red, green, blue in 0..1, multiplied into the vertex colour
  * @param alpha
  *   0..1, multiplied into the vertex alpha
  * @param combine
  *   how texture and vertex colour meet; `ColorOnly` without a texture
  * @param blend
  *   drawn after everything opaque, back to front, without writing depth
  * @param alphaTest
  *   fragments whose alpha is below this (0..1) are dropped
  * @param wrap
  *   for both texture coordinates, where the material has one of its own
  */
final case class Material(
    name: String,
    color: (Double, Double, Double),
    alpha: Double,
    texture: Option[TextureImage],
    combine: Combine,
    blend: Boolean,
    alphaTest: Option[Double],
    wrap: Option[Wrap] = None
)

object Material {

  /** White, untextured: what a mesh without a material gets. */
  val White: Material = Material("white", (1, 1, 1), 1, None, Combine.ColorOnly, blend = false, None)

  /** A picture alone, as OpenGL's "replace" shows it; opacity below 1 needs "modulate". A picture that is
    * partly transparent is blended, one that has only holes is alpha-tested.
    */
  def textured(name: String, picture: TextureImage, alpha: Double): Material = {
    val partly = picture.hasAlpha && picture.argb.exists(c => { val a = c >>> 24; a > 8 && a < 247 })
    Material(
      name,
      (1, 1, 1),
      alpha,
      Some(picture),
      if (alpha < 1) Combine.Modulate else Combine.Replace,
      blend = alpha < 1 || partly,
      alphaTest = Option.when(picture.hasAlpha && !partly && alpha == 1)(0.5)
    )
  }
}
