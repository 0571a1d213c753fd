package frustum.scene

import frustum.contract.InputError
import frustum.files.Notices
import java.nio.file.Path
import scala.collection.mutable

/** A model at its place in a scene. */
final case class VoxInstance(model: VoxModel, placement: VoxPlacement) {
  def cell(v: VoxVoxel): Seq[Int] = placement.cell(model.size, Seq(v.x, v.y, v.z))

  /** Opposite corners of the model's box, both within it. */
  def corners: Seq[Seq[Int]] = Seq(Seq(0, 0, 0), model.size.map(_ - 1)).map(placement.cell(model.size, _))
}

/** The models that a .vox file shows, in the file's order: those that its scene graph places and hides neither by a
  * node nor by a layer. Without a graph that is the first model; more of them are an animation's.
  */
object VoxScene {

  /** Nodes visited at most, a node as often as it is reached. */
  private val MostVisits = 1 << 16

  def instances(file: Path, content: VoxContent, notices: Notices): Seq[VoxInstance] = {
    import content.{models, nodes}
    def refuse(what: String): Nothing = throw InputError(s"$file: $what")
    if (models.isEmpty) refuse("has no voxels: there is no model in it (chunks SIZE and XYZI); export it again")
    notices.add(s"$file: frames of an animation after the first left out", content.frames)
    content.unknown.foreach(kind => notices.add(s"$file: chunks '$kind' are not known and left out"))

    val shown = mutable.ArrayBuffer.empty[VoxInstance]
    val named = mutable.Set.empty[Int]
    var hidden = 0
    var visits = 0

    def visit(id: Int, above: List[Int], placement: VoxPlacement, concealed: Boolean): Unit = {
      val by = above.headOption.fold("the scene graph")(n => s"node $n")
      if (above.contains(id)) refuse(s"node $id lies below itself; save it again")
      visits += 1
      if (visits > MostVisits) refuse(s"the scene graph shows more than $MostVisits nodes; join models in the editor")
      val node = nodes.getOrElse(id, refuse(s"$by names node $id, which is missing; save it again"))
      val conceal = concealed || node.hidden
      node match {
        case t: VoxTransform =>
          visit(t.child, id :: above, placement.after(t.placement), conceal || content.hiddenLayers(t.layer))
        case g: VoxGroup => g.children.foreach(visit(_, id :: above, placement, conceal))
        case s: VoxShape =>
          val model = models.lift(s.model).getOrElse(
            refuse(s"node $id shows model ${s.model}; there are ${models.length}: save it again")
          )
          named += s.model
          if (conceal) hidden += 1 else shown += VoxInstance(model, placement)
      }
    }

    if (nodes.isEmpty) {
      shown += VoxInstance(models.head, VoxPlacement.Identity)
      notices.add(s"$file: models after the first, which are an animation's, left out", models.length - 1)
    } else {
      visit(0, Nil, VoxPlacement.Identity, concealed = false)
      notices.add(s"$file: hidden models left out", hidden)
      notices.add(s"$file: models that the scene does not show left out", models.indices.count(!named(_)))
    }
    val (full, empty) = shown.toSeq.partition(_.model.voxels.nonEmpty)
    if (full.isEmpty) refuse(
      if (hidden > 0) "has no voxels to show: all models are hidden; show one in the editor and save it again"
      else "has no voxels: its models are empty; draw something and save it again"
    )
    notices.add(s"$file: models without voxels", empty.length)
    full
  }
}
