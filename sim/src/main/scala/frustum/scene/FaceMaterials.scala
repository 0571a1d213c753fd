package frustum.scene

import frustum.contract.raster.{Combine, Wrap}
import frustum.driver.scene.Material
import frustum.files.Notices
import scala.collection.mutable

/** How the faces of an OBJ file look: its materials with their pictures, as far as faces use them. */
final class FaceMaterials(obj: ObjFile, options: ObjScene.Options, notices: Notices) {
  private val pictures = {
    val used = obj.faces.filter(ObjScene.textured).map(_.material).distinct
    new MaterialPictures(options.texels, options.textureSize, options.texture, notices).read(used)
  }
  private val made = mutable.HashMap.empty[(Option[MtlMaterial], Boolean, Boolean), Material]

  def apply(face: ObjFile.Face): Material = {
    val textured = ObjScene.textured(face)
    val solid = face.corners.forall(_.color._4 == 1)
    made.getOrElseUpdate((face.material, textured, solid), material(face.material, textured, solid))
  }

  /** @param solid the vertices are opaque */
  private def material(m: Option[MtlMaterial], textured: Boolean, solid: Boolean): Material = {
    val name = m.fold(Material.White.name)(_.name)
    val alpha = m.fold(1.0)(_.alpha)
    val plain =
      Material(name, m.fold(Material.White.color)(_.color), alpha, None, Combine.ColorOnly, blend = alpha < 1, None)
    val look = if (textured) pictures.get(m).fold(plain)(withPicture(m, plain, _)) else plain
    if (solid) look
    // a texture alone would hide the vertices' alpha
    else look.copy(blend = true, combine = if (look.texture.isDefined) Combine.Modulate else look.combine)
  }

  private def withPicture(m: Option[MtlMaterial], plain: Material, picture: MaterialPicture): Material = {
    val material = Material.textured(plain.name, picture.image, plain.alpha)
    val clamped = m.flatMap(m => m.map.orElse(m.alphaMap)).exists(_.clamp)
    val wrapped = material.copy(wrap = Option.when(clamped)(Wrap.Clamp))
    if (picture.colored) wrapped else wrapped.copy(color = plain.color, combine = Combine.Modulate)
  }
}
