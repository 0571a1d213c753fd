package frustum.command.demo

import frustum.picture.Picture
import java.nio.file.Path

/** The three pictures of a scene of `demo`: as it was drawn, the reference's, and their difference. */
object DemoPictures {
  def write(
      out: Path,
      scene: String,
      width: Int,
      height: Int,
      picture: Array[Int],
      reference: Array[Int]
  ): Unit =
    for (
      (kind, shown) <- Seq(
        "" -> picture,
        ".reference" -> reference,
        ".difference" -> Picture.difference(picture, reference)
      )
    ) Picture.writePng(out.resolve(s"$scene$kind.png"), width, height, shown)
}
