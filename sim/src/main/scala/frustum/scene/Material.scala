package frustum.scene

import frustum.spec.Combine

/** How the triangles that name it look.
  *
  * @param color     red, green, blue in 0..1, multiplied into the vertex colour
  * @param alpha     0..1, multiplied into the vertex alpha
  * @param combine   how texture and vertex colour meet; `ColorOnly` without a texture
  * @param blend     drawn after everything opaque, back to front, without writing depth
  * @param alphaTest fragments whose alpha is below this (0..1) are dropped
  */
final case class Material(
    name: String,
    color: (Double, Double, Double),
    alpha: Double,
    texture: Option[TextureImage],
    combine: Combine,
    blend: Boolean,
    alphaTest: Option[Double]
)

object Material {

  /** White, untextured: what a mesh without a material gets. */
  val White: Material = Material("white", (1, 1, 1), 1, None, Combine.ColorOnly, blend = false, None)
}
