package frustum.model.video

import frustum.contract.video.{Font, TextField}

/** Model of [[frustum.video.TextOverlay]]: what is written in its fields, or nothing. */
final case class TextOverlay(fields: Seq[(TextField, Option[String])]) {

  /** 24-bit colour of a pixel with the text over it: letters white, their cells at half brightness. */
  def apply(rgb: Int, x: Int, y: Int): Int = fields
    .collectFirst {
      case (f, Some(text))
          if y / f.cell == f.row && (f.column until f.column + f.length).contains(x / f.cell) =>
        val dots = Font.row(Font.code(text(x / f.cell - f.column)), (y >> f.scale) % Font.Cell)
        if ((dots >> (7 - (x >> f.scale) % Font.Cell) & 1) == 1) 0xffffff else rgb >> 1 & 0x7f7f7f
    }
    .getOrElse(rgb)
}
